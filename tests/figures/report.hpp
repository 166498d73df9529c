// What a program measures, by name: gathered over all its queries, and printed for results.py.
//     core Cortex-M4F
//     figure kr5.rotated.close.query.mean 52422    instructions, which depend on the core
//     quotient kr5.visit.rotated.mean 873 10       the same, of which results.py makes 87.30
//     count kr5.rotated.close.visits.max 708       equal on every core and on this machine
// Where no instructions are counted, on the host, there are counts alone.
#pragma once

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "insn.hpp"

namespace figures {

/// Words that dots join, blanks in them as underscores; those that are null are left out.
struct Name {
  const char* word[5];
};

/// Its mean and maximum are printed; of one that is added once, the value alone.
void add_figure(const Name& name, uint32_t value);
/// Goes into the digest, too.
void add_count(const Name& name, uint32_t value);
/// The sums' quotient is the mean, the largest of one with a `whole` of at least kFewParts the
/// maximum.
void add_quotient(const Name& name, int64_t part, uint32_t whole);
constexpr uint32_t kFewParts = 100;

/// Into one number for all that a program counts.
void add_to_digest(uint32_t count);
inline void add_to_digest(const flashbvh::QueryStats& counts) {
  add_to_digest(counts.visits);
  add_to_digest(counts.leaf_pairs);
  add_to_digest(counts.triangle_pairs);
}

/// A figure: the instructions that `function()` takes, which are returned, too.
template <class Function>
uint32_t measure(const Name& name, const Function& function) {
  const uint32_t instructions = port::instructions_of(function);
  add_figure(name, instructions);
  return instructions;
}

/// At once, not gathered.
void print_figure(const Name& name, uint32_t value);
void print_count(const Name& name, uint32_t value);

/// What was added so far, and makes room for more.
void print_rows();
/// All that was added, in the order in which it first was, and the digest as SET.digest, if any.
/// Returns the status of a program whose answers were all `right`.
int print_all(const char* set, bool right);

}  // namespace figures
