// Writes an HTML page with a picture of every tenth frame, on the host.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <set>
#include <vector>

#include "flashbvh/self.hpp"

namespace cloth {

/// Draws triangles from back to front, lit from above. The sheet's intersecting triangles are red.
class Page {
 public:
  explicit Page(const char* path) {
    if (path != nullptr) {
      file_.open(path);
      file_ << "<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\"><title>Cloth over a "
               "link</title>\n<style>body{font:14px sans-serif}figure{display:inline-block;"
               "margin:4px}svg{width:400px;background:#f4f4f4}</style>\n";
    }
  }

  void add(int number, const flashbvh::Mesh& sheet, const flashbvh::Mesh& link) {
    if (!file_.is_open() || number % 10 != 0) {
      return;
    }
    faces_.clear();
    add_mesh(link, {}, {150, 160, 175});
    add_mesh(sheet, hits(sheet, link), {90, 140, 220});
    std::sort(faces_.begin(), faces_.end(),
              [](const Face& a, const Face& b) { return a.depth < b.depth; });
    file_ << "<figure><svg viewBox=\"-170 -260 340 380\">";
    for (const Face& face : faces_) {
      file_ << "<path fill=\"rgb(" << face.color[0] << "," << face.color[1] << "," << face.color[2]
            << ")\" d=\"M";
      for (const auto& at : face.corners) {
        file_ << static_cast<int>(at[0] * 10) / 10.0 << " " << static_cast<int>(at[1] * 10) / 10.0
              << " ";
      }
      file_ << "Z\"/>";
    }
    file_ << "</svg><figcaption>frame " << number << "</figcaption></figure>\n";
  }

 private:
  using Place = std::array<double, 3>;
  struct Face {
    double depth;
    std::array<std::array<double, 2>, 3> corners;
    std::array<int, 3> color;
  };

  /// The slots of the sheet's intersecting triangles.
  static std::set<std::uint32_t> hits(const flashbvh::Mesh& sheet, const flashbvh::Mesh& link) {
    std::set<std::uint32_t> found;
    flashbvh::SelfQuery itself(sheet);
    (void)itself.run(UINT32_MAX, [&](const flashbvh::SelfQuery::Pair&) {
      found.insert({itself.last_slots().a, itself.last_slots().b});
      return true;
    });
    const flashbvh::Pose pose = flashbvh::Pose::translated(0, 0, 0);
    flashbvh::PairQuery both(link, sheet, pose);
    (void)both.run(UINT32_MAX, [&](const flashbvh::PairQuery::Pair&) {
      found.insert(both.last_slots().b);
      return true;
    });
    return found;
  }

  void add_mesh(const flashbvh::Mesh& mesh, const std::set<std::uint32_t>& red,
                const std::array<int, 3>& color) {
    double cell = 0;
    static_assert(sizeof cell == sizeof mesh.cell_bits);
    std::memcpy(&cell, &mesh.cell_bits, sizeof cell);
    for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
      std::array<Place, 3> at;
      for (std::size_t c = 0; c < 3; ++c) {
        const flashbvh::Vertex& v = mesh.vertices[mesh.triangles[i].corner[c]];
        at[c] = {(mesh.origin[0] + v.x) * cell, (mesh.origin[1] + v.y) * cell,
                 (mesh.origin[2] + v.z) * cell};
      }
      add_face(at, red.count(i) != 0 ? std::array<int, 3>{220, 40, 40} : color);
    }
  }

  /// The view is from the front, a quarter from the side and from above.
  void add_face(const std::array<Place, 3>& at, std::array<int, 3> color) {
    Face face{};
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = 0.8 * at[c][0] + 0.6 * at[c][1];
      const double y = -0.6 * at[c][0] + 0.8 * at[c][1];
      face.corners[c] = {x, -(0.9 * at[c][2] + 0.436 * y)};
      face.depth += 0.436 * at[c][2] - 0.9 * y;
    }
    Place u;
    Place v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      u[axis] = at[1][axis] - at[0][axis];
      v[axis] = at[2][axis] - at[0][axis];
    }
    const Place n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                     u[0] * v[1] - u[1] * v[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const double light =
        length > 0 ? 0.45 + 0.55 * std::abs(0.4 * n[0] - 0.3 * n[1] + 0.87 * n[2]) / length : 1;
    for (int& part : color) {
      part = static_cast<int>(part * light);
    }
    face.color = color;
    faces_.push_back(face);
  }

  std::ofstream file_;
  std::vector<Face> faces_;
};

}  // namespace cloth
