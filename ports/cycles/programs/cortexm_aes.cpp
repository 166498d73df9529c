// Jan Oleksiewicz's AES for the Cortex-M0, M3 and M4 on the vectors of FIPS 197, appendix C.
#include <string.h>

#include "program.hpp"

#if __ARM_ARCH < 7
#define CIPHER(name) CM0_sBOX_AES##name
#else
#define CIPHER(name) CM3_1T_AES##name
#endif

extern "C" {
void CIPHER(128_keyschedule_enc)(uint8_t* round_keys, const uint8_t* key);
void CIPHER(192_keyschedule_enc)(uint8_t* round_keys, const uint8_t* key);
void CIPHER(256_keyschedule_enc)(uint8_t* round_keys, const uint8_t* key);
void CIPHER(_encrypt)(const uint8_t* round_keys, const uint8_t* in, uint8_t* out, size_t rounds);
void CIPHER(_decrypt)(const uint8_t* round_keys, const uint8_t* in, uint8_t* out, size_t rounds);
void CM3_1T_AES256_encrypt_unrolled(const uint8_t* round_keys, const uint8_t* in, uint8_t* out);
void CM3_1T_AES_keyschedule_dec(uint8_t* round_keys, size_t rounds);
void CM4_DSPsBOX_AES_encrypt(const uint8_t* round_keys, const uint8_t* in, uint8_t* out,
                             size_t rounds);
void CM4_DSPsBOX_AES_decrypt(const uint8_t* round_keys, const uint8_t* in, uint8_t* out,
                             size_t rounds);
}

namespace {

alignas(4) constexpr uint8_t kKey[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10,
                                       11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
                                       22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
alignas(4) constexpr uint8_t kPlaintext[] = {0x00, 0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77,
                                             0x88, 0x99, 0xaa, 0xbb, 0xcc, 0xdd, 0xee, 0xff};
constexpr uint8_t kCiphertexts[][16] = {{0x69, 0xc4, 0xe0, 0xd8, 0x6a, 0x7b, 0x04, 0x30, 0xd8, 0xcd,
                                         0xb7, 0x80, 0x70, 0xb4, 0xc5, 0x5a},
                                        {0xdd, 0xa9, 0x7c, 0xa4, 0x86, 0x4c, 0xdf, 0xe0, 0x6e, 0xaf,
                                         0x70, 0xa0, 0xec, 0x0d, 0x71, 0x91},
                                        {0x8e, 0xa2, 0xb7, 0xca, 0x51, 0x67, 0x45, 0xbf, 0xea, 0xfc,
                                         0x49, 0x90, 0x4b, 0x49, 0x60, 0x89}};
alignas(4) uint8_t round_keys[15 * 16];
alignas(4) uint8_t ciphertext[16];
alignas(4) uint8_t plaintext[16];

/// Returns whether the answers are correct for keys of `bits`, and clears them.
bool are_right(int bits) {
  const bool right = memcmp(ciphertext, kCiphertexts[(bits - 128) / 64], sizeof ciphertext) == 0 &&
                     memcmp(plaintext, kPlaintext, sizeof plaintext) == 0;
  memset(ciphertext, 0, sizeof ciphertext);
  memset(plaintext, 0, sizeof plaintext);
  return right;
}

/// Functions and arguments are constants for the compiler, as in the publisher's tests.
template <int kBits, void (*kSchedule)(uint8_t*, const uint8_t*)>
struct Aes {
  static constexpr size_t kRounds = kBits / 32 + 6;

  template <class Function>
  static void print(const char* name, Function function) {
    print_cycles(name, kBits, function);
  }

  static bool run() {
    print("key", [] { kSchedule(round_keys, kKey); });
    bool right = true;
#ifdef __ARM_FEATURE_DSP
    print("parallel_encrypt",
          [] { CM4_DSPsBOX_AES_encrypt(round_keys, kPlaintext, ciphertext, kRounds); });
    print("parallel_decrypt",
          [] { CM4_DSPsBOX_AES_decrypt(round_keys, ciphertext, plaintext, kRounds); });
    right = are_right(kBits);
#endif
    print("encrypt", [] { CIPHER(_encrypt)(round_keys, kPlaintext, ciphertext, kRounds); });
#if __ARM_ARCH >= 7
    print("invert", [] { CM3_1T_AES_keyschedule_dec(round_keys, kRounds); });
#endif
    print("decrypt", [] { CIPHER(_decrypt)(round_keys, ciphertext, plaintext, kRounds); });
    return are_right(kBits) && right;
  }
};

}  // namespace

int main() {
  bool right = Aes<128, CIPHER(128_keyschedule_enc)>::run();
  right = Aes<192, CIPHER(192_keyschedule_enc)>::run() && right;
  right = Aes<256, CIPHER(256_keyschedule_enc)>::run() && right;
#if __ARM_ARCH >= 7
  CIPHER(256_keyschedule_enc)(round_keys, kKey);
  const auto unrolled = [] { CM3_1T_AES256_encrypt_unrolled(round_keys, kPlaintext, ciphertext); };
  unrolled();  // fills caches, as in the publisher's tests
  print_cycles("unrolled", 256, unrolled);
  right = memcmp(ciphertext, kCiphertexts[2], sizeof ciphertext) == 0 && right;
#endif
  return end(right);
}
