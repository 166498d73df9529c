// What the queries of two images share: the images, poses, and the names of both.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/table.hpp"
#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "image/image_file.hpp"
#include "mesh/units.hpp"

namespace flashbvh::tool {

/// Two images that one query takes. UserError if they are no partners.
struct Scene {
  explicit Scene(const PosedImages& given) : a(given.a), b(given.b) { check_partners(a, b); }

  std::string names() const { return a.name() + " and " + b.name(); }
  std::string unit() const { return unit_name(a.unit()); }
  std::vector<Pose> poses(const PosedImages& given) const {
    return read_lattice_poses(given.poses, a.cell());
  }

  ImageFile a;
  ImageFile b;
};

/// "12.5 mm"; the number alone without a unit.
inline std::string length_text(double length, const std::string& unit) {
  return significant(length, 6) + (unit.empty() ? "" : " " + unit);
}

}  // namespace flashbvh::tool
