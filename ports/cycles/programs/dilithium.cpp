// Greconici, Kannwischer and Sprenkels' arithmetic of Dilithium for the Cortex-M3: products of
// polynomials modulo q, with a factor of 2^-32 per product, and their number-theoretic transform.
#include "program.hpp"

extern "C" {
void poly_pointwise_invmontgomery_asm_mul(int32_t* product, const int32_t* a, const int32_t* b);
void ntt_asm_schoolbook(int32_t* polynomial, const uint32_t* roots);
}

namespace {

constexpr int kSize = 256;
constexpr int64_t kQ = 8380417;
uint32_t roots[kSize];
int32_t a[kSize];
int32_t b[kSize];
int32_t result[kSize];

int64_t modulo(int64_t x) {
  return (x % kQ + kQ) % kQ;
}

int64_t power(int64_t base, unsigned exponent) {
  int64_t made = 1;
  for (; exponent != 0; exponent /= 2, base = modulo(base * base)) {
    made = exponent % 2 != 0 ? modulo(made * base) : made;
  }
  return made;
}

unsigned reversed(unsigned byte) {
  unsigned made = 0;
  for (int i = 0; i < 8; ++i) {
    made |= (byte >> i & 1) << (7 - i);
  }
  return made;
}

constexpr int64_t kRoot = 1753;  ///< its 256th power is -1

/// Returns whether each result is the polynomial's value at another odd power of the root.
bool is_transformed() {
  for (unsigned i = 0; i < kSize; ++i) {
    const int64_t x = power(kRoot, 2 * reversed(i) + 1);
    int64_t sum = 0;
    for (int k = kSize - 1; k >= 0; --k) {
      sum = modulo(sum * x + a[k]);
    }
    if (sum != modulo(result[i])) {
      return false;
    }
  }
  return true;
}

bool is_product() {
  for (int i = 0; i < kSize; ++i) {
    if (modulo(modulo(result[i]) * (int64_t{1} << 32)) != modulo(int64_t{a[i]} * b[i])) {
      return false;
    }
  }
  return true;
}

}  // namespace

int main() {
  for (int i = 0; i < kSize; ++i) {
    a[i] = static_cast<int32_t>(modulo(i * int64_t{0x9E3779B9}));
    b[i] = static_cast<int32_t>(modulo(i * int64_t{0x7F4A7C15}));
    result[i] = a[i];
    roots[i] = static_cast<uint32_t>(modulo((int64_t{1} << 32) % kQ * power(kRoot, reversed(i))));
  }
  print_cycles("ntt", [] { ntt_asm_schoolbook(result, roots); });
  bool right = is_transformed();
  print_cycles("product", [] { poly_pointwise_invmontgomery_asm_mul(result, a, b); });
  return end(is_product() && right);
}
