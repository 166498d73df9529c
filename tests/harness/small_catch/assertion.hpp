// CHECK and REQUIRE: expressions taken apart at their comparison, so that a failure shows both
// sides. What holds costs the comparison and a branch.
#ifndef FLASHBVH_SMALL_CATCH_ASSERTION_HPP
#define FLASHBVH_SMALL_CATCH_ASSERTION_HPP

#include "value.hpp"

namespace small_catch {

/// Where an assertion stands, and its text.
struct Site {
  const char* macro;
  const char* expression;
  const char* file;
  int line;
};

/// Report a failure: of a comparison, of a value, of a truth.
void report(const Site& site, const AnyValue& left, const char* comparison, const AnyValue& right);
void report(const Site& site, const AnyValue& value);
void report(const Site& site);

/// How many failures have been reported.
unsigned failures();

/// Ends the process with kExitCatchWouldThrow. The runner's program has it.
[[noreturn]] void stop();

template <class Left, class Right>
struct Comparison {
  const Left& left;
  const char* name;
  const Right& right;
  bool holds;
};

/// The left side of a comparison, or an expression that has none.
template <class Left>
struct Operand {
  const Left& value;

  template <class Right>
  Comparison<Left, Right> operator==(const Right& right) const {
    return {value, " == ", right, static_cast<bool>(value == right)};
  }
  template <class Right>
  Comparison<Left, Right> operator!=(const Right& right) const {
    return {value, " != ", right, static_cast<bool>(value != right)};
  }
  template <class Right>
  Comparison<Left, Right> operator<(const Right& right) const {
    return {value, " < ", right, static_cast<bool>(value < right)};
  }
  template <class Right>
  Comparison<Left, Right> operator<=(const Right& right) const {
    return {value, " <= ", right, static_cast<bool>(value <= right)};
  }
  template <class Right>
  Comparison<Left, Right> operator>(const Right& right) const {
    return {value, " > ", right, static_cast<bool>(value > right)};
  }
  template <class Right>
  Comparison<Left, Right> operator>=(const Right& right) const {
    return {value, " >= ", right, static_cast<bool>(value >= right)};
  }
};

/// `Decompose() <= a == b` groups as `(Decompose() <= a) == b`.
struct Decompose {
  template <class Left>
  Operand<Left> operator<=(const Left& left) const {
    return {left};
  }
};

template <class Left, class Right>
bool holds(const Site& site, const Comparison<Left, Right>& comparison) {
  if (!comparison.holds) {
    report(site, any_value(comparison.left), comparison.name, any_value(comparison.right));
  }
  return comparison.holds;
}

template <class Value>
bool holds(const Site& site, const Operand<Value>& operand) {
  if (operand.value) {
    return true;
  }
  report(site, any_value(operand.value));
  return false;
}

inline bool holds(const Site& site, bool truth) {
  if (!truth) {
    report(site);
  }
  return truth;
}

template <class Claim>
void check(const Site& site, const Claim& claim) {
  (void)holds(site, claim);
}

template <class Claim>
void require(const Site& site, const Claim& claim) {
  if (!holds(site, claim)) {
    stop();
  }
}

}  // namespace small_catch

#endif
