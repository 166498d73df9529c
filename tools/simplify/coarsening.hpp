// A mesh made coarser step by step, each step certified.
//
// meshoptimizer proposes a coarse mesh of each shell; what the certificate (deviation.hpp) does not
// confirm is not taken. Then edges collapse where the certificate leaves room (collapse.hpp).
// Vertices of the coarse mesh lie on the lattice, so what rounding moves is certified along.
#pragma once

#include <vector>

#include "bake/mesh.hpp"
#include "simplify/deviation.hpp"

namespace flashbvh::simplify {

class Coarsening {
 public:
  /// Lengths are in the mesh's unit. Precondition: bake::fits(mesh, cell).
  Coarsening(const bake::SourceMesh& mesh, double cell);

  /// The least limit: what rounding to the lattice moves.
  double rounding() const { return rounding_; }
  /// As coarse as it gets with every point of the original within `limit`, which is no less than
  /// rounding() and the limit before. Deterministic.
  void coarsen(double limit);

  /// coarsen() was never called: mesh() is about the original, which is to be taken in its place.
  bool is_original() const { return limit_ == 0; }
  /// Closed if the original is; vertices on the lattice, none unused.
  bake::SourceMesh mesh() const;
  /// Of the original, until it is coarsened.
  std::size_t triangle_count() const;
  /// Of any point of either mesh from the other, certified; no more than the limit.
  Deviation deviation() const;
  /// About how many triangles coarsen(limit) leaves, before it is called for the first time.
  std::size_t estimate(double limit) const;

 private:
  /// What hangs together.
  struct Shell {
    bake::SourceMesh original;
    bake::SourceMesh coarse;
    NearestTriangle nearest;  ///< of the original
  };
  /// Whether all of either mesh is certified to be near the other.
  static bool is_within(const Shell& shell, const bake::SourceMesh& coarse, double limit);
  static void propose(Shell& shell, double limit);
  void collapse(Shell& shell, double limit) const;

  double rounding_;
  double cell_;
  std::vector<Shell> shells_;
  double limit_ = 0;  ///< until now
};

}  // namespace flashbvh::simplify
