// Peter Schwabe's and Ko Stoffelen's AES-128 on the vectors of FIPS 197, appendix B.
#include <string.h>

#include "program.hpp"

extern "C" {
void AES_128_keyschedule(const uint8_t* key, uint8_t* round_keys);
void AES_128_encrypt(const uint8_t* round_keys, const uint8_t* in, uint8_t* out);
}

namespace {

alignas(4) constexpr uint8_t kKey[] = {0x2b, 0x7e, 0x15, 0x16, 0x28, 0xae, 0xd2, 0xa6,
                                       0xab, 0xf7, 0x15, 0x88, 0x09, 0xcf, 0x4f, 0x3c};
alignas(4) constexpr uint8_t kIn[] = {0x32, 0x43, 0xf6, 0xa8, 0x88, 0x5a, 0x30, 0x8d,
                                      0x31, 0x31, 0x98, 0xa2, 0xe0, 0x37, 0x07, 0x34};
constexpr uint8_t kOut[] = {0x39, 0x25, 0x84, 0x1d, 0x02, 0xdc, 0x09, 0xfb,
                            0xdc, 0x11, 0x85, 0x97, 0x19, 0x6a, 0x0b, 0x32};
alignas(4) uint8_t round_keys[11 * sizeof kKey];
alignas(4) uint8_t out[sizeof kOut];

}  // namespace

int main() {
  memcpy(round_keys, kKey, sizeof kKey);
  print_cycles("key", [] { AES_128_keyschedule(kKey, round_keys + sizeof kKey); });
  print_cycles("encrypt", [] { AES_128_encrypt(round_keys, kIn, out); });
  return end(memcmp(out, kOut, sizeof kOut) == 0);
}
