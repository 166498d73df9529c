#include "pipeline.hpp"

namespace cycles {
namespace {

bool is_load(const Instruction& instruction) {
  return instruction.kind == Kind::load;
}

}  // namespace

uint32_t wait_between(const Table& table, const Instruction& last, const Instruction& next) {
  uint32_t waits = 0;
  if ((next.address & last.computed) != 0) {
    waits += table[Rule::address_wait];
  }
  if (last.kind == Kind::store) {
    const bool loads = is_load(next) || next.kind == Kind::load_multiple;
    waits += loads ? table[Rule::load_after_store] : 0;
    waits +=
        next.kind == Kind::store && (next.address & last.updated) != 0 ? table[Rule::base_wait] : 0;
  }
  if ((next.floats_read & last.floats_written) != 0) {
    waits += table[Rule::float_wait];
  }
  return waits;
}

uint32_t Pipeline::saved_by(const Instruction& next) const {
  if (next.kind == Kind::it) {
    return last_.bytes == 2 ? table_[Rule::folded_it] : 0;
  }
  const bool can_overlap = is_load(next) || next.kind == Kind::store_indexed;
  const bool overlaps =
      can_overlap && is_load(last_) && (next.address & (last_.loaded | last_.updated)) == 0;
  const uint32_t lost = next.updated != 0 ? table_[Rule::base_update] : 0;
  return overlaps ? table_[Rule::load_after_load] - lost : 0;
}

uint32_t Pipeline::cycles_of(const Instruction& next) const {
  const Row& row = table_[next.kind];
  uint32_t cycles = row.cycles + (next.is_double ? table_[Rule::double_precision] : 0U);
  if (may_be_skipped_) {
    return cycles;
  }
  cycles += uint32_t{row.per_word} * next.words;
  if (has_last_) {
    cycles += wait_between(table_, last_, next);
    cycles -= saved_by(next);
  }
  return cycles;
}

/// During an instruction of several `cycles` the prefetch buffer fills and fetching stops. The next
/// fetch is too late for the third of the following instructions that lie in two words.
uint32_t Pipeline::fetch_waited_by(const Instruction& next, uint32_t cycles) {
  until_fetch_wait_ = next.is_split ? until_fetch_wait_ : 0;
  const bool waits = until_fetch_wait_ == 1;
  until_fetch_wait_ = cycles > 1 ? 3 : until_fetch_wait_ - (until_fetch_wait_ > 0 ? 1 : 0);
  return waits ? table_[Rule::fetch_wait] : 0;
}

uint32_t Pipeline::add(const Instruction& next) {
  may_be_skipped_ = conditional_ > 0;
  uint32_t cycles = cycles_of(next);
  cycles += fetch_waited_by(next, cycles);
  conditional_ = next.kind == Kind::it ? next.governed : conditional_ - (may_be_skipped_ ? 1 : 0);
  last_ = next;
  has_last_ = !may_be_skipped_;
  return cycles;
}

}  // namespace cycles
