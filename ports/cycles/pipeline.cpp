#include "pipeline.hpp"

namespace cycles {
namespace {

bool is_load(const Instruction& instruction) {
  return instruction.kind == Kind::load;
}

}  // namespace

uint32_t Pipeline::saved_by(const Instruction& next) const {
  if (next.kind == Kind::it) {
    return last_.bytes == 2 ? table_[Rule::folded_it] : 0;
  }
  const bool can_overlap = is_load(next) || next.kind == Kind::store_indexed;
  const bool overlaps = can_overlap && is_load(last_) && (next.address & last_.loaded) == 0;
  return overlaps ? table_[Rule::load_after_load] : 0;
}

uint32_t Pipeline::waited_by(const Instruction& next) const {
  uint32_t waits = 0;
  if ((next.address & last_.computed) != 0) {
    waits += table_[Rule::address_wait];
  }
  if ((next.floats_read & last_.floats_written) != 0) {
    waits += table_[Rule::float_wait];
  }
  return waits;
}

uint32_t Pipeline::cycles_of(const Instruction& next) const {
  const Row& row = table_[next.kind];
  uint32_t cycles = row.cycles + (next.is_double ? table_[Rule::double_precision] : 0U);
  if (may_be_skipped_) {
    return cycles;
  }
  cycles += uint32_t{row.per_word} * next.words;
  if (has_last_) {
    cycles += waited_by(next);
    cycles -= saved_by(next);
  }
  return cycles;
}

uint32_t Pipeline::add(const Instruction& next) {
  may_be_skipped_ = conditional_ > 0;
  const uint32_t cycles = cycles_of(next);
  conditional_ = next.kind == Kind::it ? next.governed : conditional_ - (may_be_skipped_ ? 1 : 0);
  last_ = next;
  has_last_ = !may_be_skipped_;
  return cycles;
}

}  // namespace cycles
