// Coarsens a mesh step by step, each step certified.
//
// meshoptimizer proposes a coarse mesh of each shell; a proposal that the certificate
// (deviation.hpp) does not confirm is rejected. Then edges collapse where the certificate allows
// (collapse.hpp). The coarse mesh's vertices lie on the lattice, so certificates cover rounding.
#pragma once

#include <memory>
#include <vector>

#include "bake/mesh.hpp"
#include "simplify/deviation.hpp"
#include "text/deadline.hpp"

namespace flashbvh::simplify {

class Coarsening {
 public:
  /// `rounded`: the mesh on the lattice. Lengths are in the mesh's unit.
  Coarsening(const bake::SourceMesh& mesh, bake::LatticeMesh rounded);
  /// Precondition: the mesh fits the lattice with this cell.
  Coarsening(const bake::SourceMesh& mesh, double cell);

  /// The least limit: the motion by rounding to the lattice, and the rounding of doubles.
  double rounding() const { return rounded_->deviation + 3 * margin_; }
  /// Coarsens as far as possible with every point of the original within `limit`, which is at least
  /// rounding() and the last limit. Deterministic, unless the deadline passes before.
  void coarsen(double limit, const tool::Deadline& deadline = {});
  /// True if coarsen() ended at its deadline, with more triangles than possible.
  bool is_unfinished() const { return is_unfinished_; }

  /// The original on the lattice.
  const bake::LatticeMesh& rounded() const { return *rounded_; }
  /// True before the first coarsen(): use the original then; mesh() is only close to it.
  bool is_original() const { return limit_ == 0; }
  /// Closed if the original is; vertices on the lattice, none unused.
  bake::SourceMesh mesh() const;
  /// Of the original before the first coarsen().
  std::size_t triangle_count() const;
  /// The certified deviation of each mesh from the other; at most the limit, which each step kept.
  /// Infinite if a point exceeds the limit all the same: an error of the program.
  Deviation deviation() const;
  /// An estimate of the triangles that the first coarsen(limit) leaves.
  std::size_t estimate(double limit) const;

 private:
  /// A connected part of the mesh.
  struct Shell {
    bake::SourceMesh original;
    bake::SourceMesh coarse;
    NearestTriangle nearest;  ///< of the original
  };
  /// True if each mesh is certified to be within `limit` of the other.
  static bool is_within(const Shell& shell, const bake::SourceMesh& coarse, double limit);
  static void propose(Shell& shell, double limit, const tool::Deadline& deadline);
  void collapse(Shell& shell, double limit, const tool::Deadline& deadline) const;

  std::shared_ptr<const bake::LatticeMesh> rounded_;  ///< of copies, too
  double margin_;  ///< kErrors times the arithmetic error of the whole mesh
  std::vector<Shell> shells_;
  double limit_ = 0;  ///< of the last coarsen()
  bool is_unfinished_ = false;
};

}  // namespace flashbvh::simplify
