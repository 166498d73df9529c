// Peter Schwabe's and Ko Stoffelen's AES on the vectors of FIPS 197, appendices A and B.
#include <string.h>

#include "program.hpp"

extern "C" {
void AES_128_keyschedule(const uint8_t* key, uint8_t* round_keys);
void AES_192_keyschedule(const uint8_t* key, uint8_t* round_keys);
void AES_256_keyschedule(const uint8_t* key, uint8_t* round_keys);
void AES_128_encrypt(const uint8_t* round_keys, const uint8_t* in, uint8_t* out);
}

namespace {

alignas(4) constexpr uint8_t kKey[] = {0x2b, 0x7e, 0x15, 0x16, 0x28, 0xae, 0xd2, 0xa6,
                                       0xab, 0xf7, 0x15, 0x88, 0x09, 0xcf, 0x4f, 0x3c};
alignas(4) constexpr uint8_t kKey192[] = {0x8e, 0x73, 0xb0, 0xf7, 0xda, 0x0e, 0x64, 0x52,
                                          0xc8, 0x10, 0xf3, 0x2b, 0x80, 0x90, 0x79, 0xe5,
                                          0x62, 0xf8, 0xea, 0xd2, 0x52, 0x2c, 0x6b, 0x7b};
alignas(4) constexpr uint8_t kKey256[] = {
    0x60, 0x3d, 0xeb, 0x10, 0x15, 0xca, 0x71, 0xbe, 0x2b, 0x73, 0xae, 0xf0, 0x85, 0x7d, 0x77, 0x81,
    0x1f, 0x35, 0x2c, 0x07, 0x3b, 0x61, 0x08, 0xd7, 0x2d, 0x98, 0x10, 0xa3, 0x09, 0x14, 0xdf, 0xf4};
constexpr uint8_t kLast192[] = {0x01, 0x00, 0x22, 0x02};
constexpr uint8_t kLast256[] = {0x70, 0x6c, 0x63, 0x1e};
alignas(4) constexpr uint8_t kIn[] = {0x32, 0x43, 0xf6, 0xa8, 0x88, 0x5a, 0x30, 0x8d,
                                      0x31, 0x31, 0x98, 0xa2, 0xe0, 0x37, 0x07, 0x34};
constexpr uint8_t kOut[] = {0x39, 0x25, 0x84, 0x1d, 0x02, 0xdc, 0x09, 0xfb,
                            0xdc, 0x11, 0x85, 0x97, 0x19, 0x6a, 0x0b, 0x32};
alignas(4) uint8_t round_keys[11 * sizeof kKey];
alignas(4) uint8_t round_keys_192[13 * 16];
alignas(4) uint8_t round_keys_256[15 * 16];
alignas(4) uint8_t out[sizeof kOut];

}  // namespace

int main() {
  memcpy(round_keys, kKey, sizeof kKey);
  print_cycles("key", [] { AES_128_keyschedule(kKey, round_keys + sizeof kKey); });
  print_cycles("encrypt", [] { AES_128_encrypt(round_keys, kIn, out); });
  print_cycles("key192", [] { AES_192_keyschedule(kKey192, round_keys_192 + sizeof kKey192); });
  print_cycles("key256", [] { AES_256_keyschedule(kKey256, round_keys_256 + sizeof kKey256); });
  return end(memcmp(round_keys_192 + sizeof round_keys_192 - 4, kLast192, 4) == 0 &&
             memcmp(round_keys_256 + sizeof round_keys_256 - 4, kLast256, 4) == 0 &&
             memcmp(out, kOut, sizeof kOut) == 0);
}
