// Emil Lenngren's key agreement on P-256 for the Cortex-M0, on the vector of RFC 5903, 8.1.
#include <string.h>

#include "program.hpp"

extern "C" {
bool P256_ecdh_keygen(uint8_t* public_point, const uint8_t* private_key);
bool P256_ecdh_shared_secret(uint8_t* secret, const uint8_t* public_point,
                             const uint8_t* private_key);
}

namespace {

// Numbers of 256 bits, lowest word first.
constexpr uint32_t kMine[] = {0x862d1433, 0xc62a9c57, 0xafe84049, 0x44e9aab8,
                              0xa2316de5, 0x70a292da, 0x10d9ac3f, 0xc88f01f5};
constexpr uint32_t kOther[] = {0x476bee53, 0xb283ab46, 0x06bf9be0, 0x88685d8f,
                               0xb397ce20, 0x011164ac, 0x78ae012a, 0xc6ef9c5d};
constexpr uint32_t kSecret[] = {0x4b9442de, 0x812464d0, 0xce7dce03, 0x2fef8e9e,
                                0xe1256520, 0xd13116e0, 0x42f6edaf, 0xd6840f6b};
uint8_t public_point[64];
uint8_t secret[sizeof kSecret];

const uint8_t* bytes(const uint32_t* words) {
  return reinterpret_cast<const uint8_t*>(words);
}

}  // namespace

int main() {
  P256_ecdh_keygen(public_point, bytes(kOther));
  print_cycles("p256", [] { P256_ecdh_shared_secret(secret, public_point, bytes(kMine)); });
  return end(memcmp(secret, kSecret, sizeof kSecret) == 0);
}
