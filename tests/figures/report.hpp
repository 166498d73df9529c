// A program's measurements, by name: gathered over all its queries, and printed for results.py.
//     core Cortex-M4F
//     figure kr5.rotated.close.query.mean 52422    instructions, which depend on the core
//     quotient kr5.visit.rotated.mean 873 10       instructions; results.py computes 87.30
//     count kr5.rotated.close.visits.max 708       equal on every core and on this machine
// The host counts no instructions and prints only counts.
#pragma once

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "insn.hpp"

namespace figures {

/// Words joined by dots, with blanks as underscores; null words are left out.
struct Name {
  const char* word[5];
};

/// Adds a value; the mean and maximum are printed, or the value alone if it is added once.
void add_figure(const Name& name, uint32_t value);
/// Adds a count, also to the digest.
void add_count(const Name& name, uint32_t value);
/// Adds a quotient: the mean is the quotient of the sums; the maximum is the largest quotient with
/// a `whole` of at least kFewParts.
void add_quotient(const Name& name, int64_t part, uint32_t whole);
constexpr uint32_t kFewParts = 100;

/// Hashes all counts of a program into one number.
void add_to_digest(uint32_t count);
inline void add_to_digest(const flashbvh::QueryStats& counts) {
  add_to_digest(counts.visits);
  add_to_digest(counts.leaf_pairs);
  add_to_digest(counts.triangle_pairs);
}

/// Adds a figure, the instructions of `function()`, and returns it.
template <class Function>
uint32_t measure(const Name& name, const Function& function) {
  const uint32_t instructions = port::instructions_of(function);
  add_figure(name, instructions);
  return instructions;
}

/// Prints at once, without gathering.
void print_figure(const Name& name, uint32_t value);
void print_count(const Name& name, uint32_t value);

/// Prints and clears all rows so far.
void print_rows();
/// Prints all rows, in the order of their first addition, and the digest as SET.digest, if any.
/// Returns the exit status of a program whose answers were all `right`.
int print_all(const char* set, bool right);

}  // namespace figures
