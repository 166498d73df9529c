// The setups of the paper's section 9, tables 2 to 8, with our object in place of theirs.
//
// Translation only. Each pose was chosen for what its table is about, by the counts of
// `volume-stack` and of the geometry; tests/scene holds each setup to it.
#ifndef FLASHBVH_TOOLS_EVALUATE_SETUPS_HPP
#define FLASHBVH_TOOLS_EVALUATE_SETUPS_HPP

#include <array>
#include <cstdint>

#include "evaluate/paper_object.hpp"
#include "flashbvh/lattice.hpp"

namespace flashbvh::scene {

struct Setup {
  std::uint32_t table;  ///< the paper's number, 2 to 8
  const char* name;     ///< as in the table
  PaperObject a;
  PaperObject b;
  Point translation;          ///< of B in A's frame, in cells
  std::uint32_t repetitions;  ///< the paper's, for one sample of the time
};

constexpr std::uint32_t kFirstTable = 2;
constexpr std::uint32_t kLastTable = 8;

/// In the order of the tables.
extern const std::array<Setup, 20> kSetups;

/// What a table is about, in a few words.
const char* table_title(std::uint32_t table);

}  // namespace flashbvh::scene

#endif
