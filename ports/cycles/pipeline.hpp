// The cycles of consecutive instructions.
#pragma once

#include "table.hpp"
#include "thumb.hpp"

namespace cycles {

/// Cycles that `next` takes in addition right after `last`, if `last` is executed.
uint32_t wait_between(const Table& table, const Instruction& last, const Instruction& next);

class Pipeline {
 public:
  explicit Pipeline(const Table& table) : table_(table) {}

  /// Returns the cycles of `next` after all instructions added before, without a jump.
  uint32_t add(const Instruction& next);

  /// Returns whether `add` left out the last one's accesses, as its condition may fail.
  bool may_be_skipped() const { return may_be_skipped_; }

 private:
  uint32_t cycles_of(const Instruction& next) const;
  uint32_t saved_by(const Instruction& next) const;
  uint32_t fetch_waited_by(const Instruction& next, uint32_t cycles);

  const Table& table_;
  Instruction last_ = {};
  unsigned conditional_ = 0;       ///< number of further instructions that an IT governs
  unsigned until_fetch_wait_ = 0;  ///< number of instructions in two words; 0: none waits
  bool has_last_ = false;
  bool may_be_skipped_ = false;
};

}  // namespace cycles
