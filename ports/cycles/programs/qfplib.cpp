// Mark Owen's Qfplib-M0-tiny on random floats, against the compiler's library.
//
// The published averages include an overhead of the call that is not stated. So each function is
// compared by its cycles beyond those of the shortest function, qfp_fcmp.
#include "program.hpp"

extern "C" {
uint32_t qfp_fcmp(uint32_t, uint32_t);
uint32_t qfp_fadd(uint32_t, uint32_t);
uint32_t qfp_fsub(uint32_t, uint32_t);
uint32_t qfp_fmul(uint32_t, uint32_t);
uint32_t qfp_fdiv(uint32_t, uint32_t);
uint32_t qfp_fdiv_fast(uint32_t, uint32_t);
uint32_t __aeabi_fadd(uint32_t, uint32_t);
uint32_t __aeabi_fsub(uint32_t, uint32_t);
uint32_t __aeabi_fmul(uint32_t, uint32_t);
uint32_t __aeabi_fdiv(uint32_t, uint32_t);
}

namespace {

using Function = uint32_t (*)(uint32_t, uint32_t);

uint32_t random_bits() {
  static uint32_t state = 1;
  state = state * 1664525 + 1013904223;
  return state >> 8;
}

/// A random float of either sign, from 1/8 to 16.
uint32_t random_float() {
  const uint32_t sign_and_mantissa = (random_bits() << 9 ^ random_bits()) & 0x807FFFFF;
  return sign_and_mantissa | (124 + random_bits() % 7) << 23;
}

struct Call {
  Function function;
  uint32_t x;
  uint32_t y;
  uint32_t result;
};

constexpr int kCalls = 300;

/// Sums the cycles of random calls; `same_as`, unless null, must give equal results.
uint32_t cycles_of(Function function, Function same_as, bool* right) {
  uint32_t cycles = 0;
  for (int i = 0; i < kCalls; ++i) {
    Call call = {function, random_float(), random_float(), 0};
    cycles += port::cycles_of_call(
        [](void* at) {
          Call& made = *static_cast<Call*>(at);
          made.result = made.function(made.x, made.y);
        },
        &call);
    *right = *right && (same_as == nullptr || call.result == same_as(call.x, call.y));
  }
  return cycles;
}

}  // namespace

int main() {
  bool right = true;
  const uint32_t comparison = cycles_of(qfp_fcmp, nullptr, &right);
  const struct {
    const char* name;
    Function function;
    Function same_as;
  } functions[] = {{"fadd", qfp_fadd, __aeabi_fadd},
                   {"fsub", qfp_fsub, __aeabi_fsub},
                   {"fmul", qfp_fmul, __aeabi_fmul},
                   {"fdiv", qfp_fdiv, __aeabi_fdiv},
                   {"fdiv_fast", qfp_fdiv_fast, nullptr}};
  for (const auto& tested : functions) {
    const uint32_t cycles = cycles_of(tested.function, tested.same_as, &right) - comparison;
    port::print("cycles ", tested.name, " ", (cycles + kCalls / 2) / kCalls, "\n");
  }
  return end(right);
}
