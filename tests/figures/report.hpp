// What the firmware prints, for tools/figures.sh to gather:
//     core Cortex-M4F
//     figure kr5.visit.rotated.mean 87.25    instructions, which depend on the core
//     count kr5.visits.close.rotated.max 888  what every core and this machine must agree about
// Where no instructions are counted, on the host, there are counts alone.
#ifndef FLASHBVH_TESTS_FIGURES_REPORT_HPP
#define FLASHBVH_TESTS_FIGURES_REPORT_HPP

#include <stdint.h>

#include "digest/digest.hpp"
#include "flashbvh/query.hpp"

namespace figures {

/// Words that dots join; those after the last are null.
struct Name {
  const char* word[6];
};

/// Mean and maximum of something.
class Spread {
 public:
  void add(uint32_t value) {
    sum_ += value;
    ++count_;
    most_ = value > most_ ? value : most_;
  }
  uint64_t sum() const { return sum_; }
  uint32_t count() const { return count_; }
  uint32_t most() const { return most_; }
  /// Rounded.
  uint32_t mean() const {
    return count_ == 0 ? 0 : static_cast<uint32_t>((sum_ + count_ / 2) / count_);
  }

 private:
  uint64_t sum_ = 0;
  uint32_t count_ = 0;
  uint32_t most_ = 0;
};

/// One number for all that a program counts.
class Digest {
 public:
  void add(uint32_t count) { hash_.add(count); }
  void add(const flashbvh::Counts& counts) {
    add(counts.visits);
    add(counts.leaf_pairs);
    add(counts.triangle_pairs);
  }
  uint32_t value() const { return static_cast<uint32_t>(hash_.value() ^ hash_.value() >> 32); }

 private:
  digest::Hash hash_;
};
inline Digest counted;

void print_core();
void print_count(const Name& name, uint32_t value);
void print_figure(const Name& name, uint32_t value);
/// With two digits after the point, rounded; nothing if `whole` is 0.
void print_quotient(const Name& name, uint64_t part, uint64_t whole);

/// NAME.mean and NAME.max.
void print_counts(Name name, const Spread& spread);
void print_figures(Name name, const Spread& spread);

}  // namespace figures

#endif
