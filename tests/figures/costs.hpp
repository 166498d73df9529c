// A program's measurements, printed for figures.py, which sums up those of one name.
//     core Cortex-M4F
//     figure kr5.rotated.close.query 52422    instructions, which depend on the core
//     count kr5.rotated.close.visits 708      equal on every core and on this machine
// The host counts no instructions and prints only counts.
#pragma once

#include <stdint.h>

#include "flashbvh/query.hpp"
#include "insn.hpp"

namespace figures {

/// Words joined by dots; null words are left out.
struct Name {
  const char* word[5];
};

/// Prints a value.
void add_figure(const Name& name, uint32_t value);
/// Prints a count, and adds it to the digest.
void add_count(const Name& name, uint32_t value);

/// Hashes the counts of a part into one number.
void add_to_digest(uint32_t count);
inline void add_to_digest(const flashbvh::QueryStats& counts) {
  add_to_digest(counts.visits);
  add_to_digest(counts.leaf_pairs);
  add_to_digest(counts.triangle_pairs);
}

/// Prints a figure, the instructions of `function()`.
template <class Function>
void measure(const Name& name, const Function& function) {
  add_figure(name, port::instructions_of(function));
}

/// The parts of the program: each adds its figures, and returns whether its answers are right.
bool measure_queries();
bool measure_distances();
bool measure_rays();
bool measure_contacts();
bool measure_bending();
bool measure_motions();
bool measure_guard();

}  // namespace figures
