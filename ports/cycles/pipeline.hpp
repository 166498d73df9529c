// The cycles of instructions that are executed one after the other.
#pragma once

#include "table.hpp"
#include "thumb.hpp"

namespace cycles {

/// What an instruction takes in addition right after another one that is executed.
uint32_t wait_between(const Table& table, const Instruction& last, const Instruction& next);

class Pipeline {
 public:
  explicit Pipeline(const Table& table) : table_(table) {}

  /// What `next` adds; it is executed after those that were added before. A jump is not in it.
  uint32_t add(const Instruction& next);

  /// Whether `add` counted the last one without its accesses, as its condition may fail.
  bool may_be_skipped() const { return may_be_skipped_; }

 private:
  uint32_t cycles_of(const Instruction& next) const;
  uint32_t saved_by(const Instruction& next) const;
  uint32_t fetch_waited_by(const Instruction& next, uint32_t cycles);

  const Table& table_;
  Instruction last_ = {};
  unsigned conditional_ = 0;       ///< instructions to come that an IT governs
  unsigned until_fetch_wait_ = 0;  ///< instructions in two words; 0: none waits
  bool has_last_ = false;
  bool may_be_skipped_ = false;
};

}  // namespace cycles
