// Joost Rijneveld's ChaCha permutations, against the rounds of RFC 8439, 2.1 to 2.3.
#include <string.h>

#include "program.hpp"

extern "C" {
void chacha8_perm_asm(uint32_t* out, const uint32_t* in);
void chacha12_perm_asm(uint32_t* out, const uint32_t* in);
void chacha20_perm_asm(uint32_t* out, const uint32_t* in);
}

namespace {

uint32_t in[16];
uint32_t out[16];

uint32_t rotated(uint32_t x, int left) {
  return x << left | x >> (32 - left);
}

void add_and_mix(uint32_t& sum, uint32_t term, uint32_t& mixed, int left) {
  sum += term;
  mixed = rotated(mixed ^ sum, left);
}

void quarter_round(uint32_t* x, int a, int b, int c, int d) {
  add_and_mix(x[a], x[b], x[d], 16);
  add_and_mix(x[c], x[d], x[b], 12);
  add_and_mix(x[a], x[b], x[d], 8);
  add_and_mix(x[c], x[d], x[b], 7);
}

bool is_permuted(int rounds) {
  uint32_t x[16];
  memcpy(x, in, sizeof x);
  for (int round = 0; round < rounds; ++round) {
    const int turn = round % 2;
    for (int i = 0; i < 4; ++i) {
      quarter_round(x, i, 4 + (i + turn) % 4, 8 + (i + 2 * turn) % 4, 12 + (i + 3 * turn) % 4);
    }
  }
  return memcmp(x, out, sizeof x) == 0;
}

}  // namespace

int main() {
  for (uint32_t i = 0; i < 16; ++i) {
    in[i] = i * 0x9E3779B9;
  }
  print_cycles("chacha8", [] { chacha8_perm_asm(out, in); });
  bool right = is_permuted(8);
  print_cycles("chacha12", [] { chacha12_perm_asm(out, in); });
  right = is_permuted(12) && right;
  print_cycles("chacha20", [] { chacha20_perm_asm(out, in); });
  return end(is_permuted(20) && right);
}
