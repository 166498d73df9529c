// Emil Lenngren's X25519 on the first test vector of RFC 7748, 5.2, and its arithmetic.
#include <string.h>

#include "program.hpp"

extern "C" void curve25519_scalarmult(uint8_t* result, const uint8_t* scalar, const uint8_t* point);

namespace {

constexpr uint8_t kScalar[] = {0xa5, 0x46, 0xe3, 0x6b, 0xf0, 0x52, 0x7c, 0x9d, 0x3b, 0x16, 0x15,
                               0x4b, 0x82, 0x46, 0x5e, 0xdd, 0x62, 0x14, 0x4c, 0x0a, 0xc1, 0xfc,
                               0x5a, 0x18, 0x50, 0x6a, 0x22, 0x44, 0xba, 0x44, 0x9a, 0xc4};
constexpr uint8_t kPoint[] = {0xe6, 0xdb, 0x68, 0x67, 0x58, 0x30, 0x30, 0xdb, 0x35, 0x94, 0xc1,
                              0xa4, 0x24, 0xb1, 0x5f, 0x7c, 0x72, 0x66, 0x24, 0xec, 0x26, 0xb3,
                              0x35, 0x3b, 0x10, 0xa9, 0x03, 0xa6, 0xd0, 0xab, 0x1c, 0x4c};
constexpr uint8_t kProduct[] = {0xc3, 0xda, 0x55, 0x37, 0x9d, 0xe9, 0xc6, 0x90, 0x8e, 0x94, 0xea,
                                0x4d, 0xf2, 0x8d, 0x08, 0x4f, 0x32, 0xec, 0xcf, 0x03, 0x49, 0x1c,
                                0x71, 0xf7, 0x54, 0xb4, 0x07, 0x55, 0x77, 0xa2, 0x85, 0x52};

uint32_t words[8];

// Its arithmetic has a convention of calls of its own. Published are the cycles with the call and
// the return, so what is subtracted is the code around the call.
#define AROUND(name, call)                                                              \
  __attribute__((naked)) void name(void*) {                                             \
    __asm__ volatile(                                                                   \
        "push {r4-r11, lr}\n mov r8, r0\n mov r9, r0\n mov r1, r0\n mov r2, r0\n " call \
        "\n pop {r4-r11, pc}");                                                         \
  }
AROUND(nothing, "")
AROUND(add, "bl fe25519_add")
AROUND(subtract, "bl fe25519_sub")
AROUND(multiply, "bl fe25519_mul")
AROUND(square, "bl fe25519_sqr")

void print_call(const char* name, port::Call call) {
  const uint32_t around = port::cycles_of_call(nothing, words);
  port::print("cycles ", name, " ", port::cycles_of_call(call, words) - around, "\n");
}

}  // namespace

int main() {
  static uint8_t product[sizeof kProduct];
  print_cycles("x25519", [] { curve25519_scalarmult(product, kScalar, kPoint); });
  print_call("add", add);
  print_call("sub", subtract);
  print_call("mul", multiply);
  print_call("sqr", square);
  return end(memcmp(product, kProduct, sizeof kProduct) == 0);
}
