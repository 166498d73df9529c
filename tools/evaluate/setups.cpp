#include "evaluate/setups.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace flashbvh::scene {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kGrid = 1 << kMaxSubdivisions;  // midpoints are exact down to the last subdivision
constexpr std::uint32_t kSegments = 22;

struct ProfilePoint {
  double radius;
  double height;
};

/// From the bottom up the outer wall, over the rim, down the inner wall. Lengths in rim radii.
constexpr ProfilePoint kRings[] = {
    {0.25, -0.80}, {0.46, -0.77}, {0.58, -0.62}, {0.65, -0.42}, {0.72, -0.22}, {0.79, -0.02},
    {0.86, 0.18},  {0.92, 0.38},  {0.97, 0.58},  {1.00, 0.76},  {0.82, 0.80},  {0.76, 0.60},
    {0.70, 0.38},  {0.63, 0.15},  {0.56, -0.08}, {0.48, -0.30}, {0.36, -0.45}, {0.19, -0.50}};
constexpr double kOuterPole = -0.80;
constexpr double kInnerPole = -0.51;
constexpr std::uint32_t kRingCount = sizeof kRings / sizeof kRings[0];

/// Edges along these two rings, at segment 0, are split; each split adds two triangles.
constexpr std::uint32_t kSplitRings[] = {5, 14};
static_assert(2 * kSegments * kRingCount + 2 * 2 == kPaperFaces, "two fans, bands, two splits");

/// The sine of step / kSegments of a turn, rounded to 2^-24, so that it does not depend on the last
/// bit of the math library.
double sine(std::uint32_t step) {
  return std::round(std::sin(kTurn * (step % kSegments) / kSegments) * 16777216.0) / 16777216.0;
}

double cosine(std::uint32_t step) {
  return std::round(std::cos(kTurn * (step % kSegments) / kSegments) * 16777216.0) / 16777216.0;
}

std::int16_t on_grid(double cells) {
  return static_cast<std::int16_t>(std::lround(cells / kGrid) * static_cast<long>(kGrid));
}

Vertex ring_vertex(const ProfilePoint& ring, std::uint32_t step, double size) {
  const double lobes = 1 + 0.06 * sine(3 * step) + 0.03 * cosine(2 * step + 1);
  const double radius = ring.radius * lobes * size;
  const double height = (ring.height + 0.02 * ring.radius * sine(2 * step)) * size;
  return {on_grid(radius * cosine(step)), on_grid(radius * sine(step)), on_grid(height)};
}

std::uint32_t ring_index(std::uint32_t ring, std::uint32_t step) {
  return ring * kSegments + step % kSegments;
}

void add_bands(bake::LatticeMesh& mesh) {
  for (std::uint32_t ring = 0; ring + 1 < kRingCount; ++ring) {
    for (std::uint32_t step = 0; step < kSegments; ++step) {
      const std::uint32_t here = ring_index(ring, step);
      const std::uint32_t across = ring_index(ring + 1, step + 1);
      mesh.triangles.push_back({here, ring_index(ring, step + 1), across});
      mesh.triangles.push_back({here, across, ring_index(ring + 1, step)});
    }
  }
}

/// Adds the bottom, seen from below, and the inner bottom, seen from above.
void add_fans(bake::LatticeMesh& mesh, double size) {
  const auto outer = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({0, 0, on_grid(kOuterPole * size)});
  mesh.vertices.push_back({0, 0, on_grid(kInnerPole * size)});
  for (std::uint32_t step = 0; step < kSegments; ++step) {
    mesh.triangles.push_back({outer, ring_index(0, step + 1), ring_index(0, step)});
    mesh.triangles.push_back(
        {outer + 1, ring_index(kRingCount - 1, step), ring_index(kRingCount - 1, step + 1)});
  }
}

Vertex midpoint(const Vertex& p, const Vertex& q, double grid) {
  const auto half = [grid](int sum) {
    return static_cast<std::int16_t>(std::lround(sum / (2 * grid)) * static_cast<long>(grid));
  };
  return {half(p.x + q.x), half(p.y + q.y), half(p.z + q.z)};
}

/// Puts a vertex in the middle of an edge and splits both of its triangles.
void split_edge(bake::LatticeMesh& mesh, std::uint32_t from, std::uint32_t to) {
  const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(midpoint(mesh.vertices[from], mesh.vertices[to], kGrid));
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t start = mesh.triangles[i][corner];
      const std::uint32_t end = mesh.triangles[i][(corner + 1) % 3];
      const std::uint32_t third = mesh.triangles[i][(corner + 2) % 3];
      if ((start == from && end == to) || (start == to && end == from)) {
        mesh.triangles[i] = {start, middle, third};
        mesh.triangles.push_back({middle, end, third});
        break;
      }
    }
  }
}

/// One vertex in the middle of each edge, shared by both of its triangles.
class Midpoints {
 public:
  explicit Midpoints(bake::LatticeMesh& mesh) : mesh_(mesh) {}

  std::uint32_t between(std::uint32_t from, std::uint32_t to) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [entry, inserted] = known_.emplace(std::minmax({from, to}), next);
    if (inserted) {
      mesh_.vertices.push_back(midpoint(mesh_.vertices[from], mesh_.vertices[to], 1));
    }
    return entry->second;
  }

 private:
  bake::LatticeMesh& mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known_;
};

void subdivide(bake::LatticeMesh& mesh) {
  const std::vector<bake::TriangleCorners> coarse = std::move(mesh.triangles);
  mesh.triangles.clear();
  mesh.triangles.reserve(4 * coarse.size());
  Midpoints midpoints(mesh);
  for (const auto& [p, q, r] : coarse) {
    const std::uint32_t pq = midpoints.between(p, q);
    const std::uint32_t qr = midpoints.between(q, r);
    const std::uint32_t rp = midpoints.between(r, p);
    mesh.triangles.insert(mesh.triangles.end(),
                          {{p, pq, rp}, {pq, q, qr}, {rp, qr, r}, {pq, qr, rp}});
  }
}

Vertex rotated(const Vertex& v, Orientation orientation) {
  const auto negated = [](std::int16_t value) { return static_cast<std::int16_t>(-value); };
  switch (orientation) {
    case Orientation::lying:
      return {v.x, negated(v.z), v.y};
    case Orientation::upside_down:
      return {v.x, negated(v.y), negated(v.z)};
    case Orientation::upright:
      break;
  }
  return v;
}

constexpr PaperObject upright(std::uint32_t subdivisions) {
  return {subdivisions, kFullRadius, Orientation::upright};
}

constexpr PaperObject kUpright = upright(0);
constexpr PaperObject kLying = {0, kFullRadius, Orientation::lying};
constexpr PaperObject kUpsideDown = {0, kFullRadius, Orientation::upside_down};
constexpr PaperObject kTenth = {0, kFullRadius / 10, Orientation::upright};

/// Two upright tumblers side by side, with intersecting walls: tables 6 and 8.
constexpr Point kIntersecting = {-2900, 13600, 800};
/// The small tumbler is in the thick bottom of the large one, outside all of its triangles' boxes.
constexpr Point kInTheWall = {-1300, 1500, 7900};

}  // namespace

std::string name_of(const PaperObject& object) {
  constexpr const char* kOrientations[] = {"upright", "lying", "upside_down"};
  return std::string(kOrientations[static_cast<std::size_t>(object.orientation)]) + "_" +
         std::to_string(object.faces()) + "_radius_" + std::to_string(object.radius);
}

bake::LatticeMesh make_mesh(const PaperObject& object) {
  bake::LatticeMesh mesh;
  for (const ProfilePoint& ring : kRings) {
    for (std::uint32_t step = 0; step < kSegments; ++step) {
      mesh.vertices.push_back(ring_vertex(ring, step, object.radius));
    }
  }
  add_bands(mesh);
  add_fans(mesh, object.radius);
  for (const std::uint32_t ring : kSplitRings) {
    split_edge(mesh, ring_index(ring, 0), ring_index(ring, 1));
  }
  for (std::uint32_t i = 0; i < object.subdivisions; ++i) {
    subdivide(mesh);
  }
  for (Vertex& vertex : mesh.vertices) {
    vertex = rotated(vertex, object.orientation);
  }
  return mesh;
}

const std::array<Setup, 20> kSetups = {{
    {2, "Intersection test 1", kUpright, kUpright, {14700, -1200, -200}, 1000},
    {2, "Intersection test 2", kUpright, kUpsideDown, {5500, -7200, -5900}, 1000},
    {2, "Intersection test 3", kUpright, kLying, {11900, 1100, -2800}, 1000},

    {3, "Separation test 1", kUpright, kUpright, {26000, 4000, 1000}, 100000},
    {3, "Separation test 2", kUpright, kUpsideDown, {-3000, 27000, -5000}, 100000},
    {3, "Separation test 3", kUpright, kLying, {6000, -2000, 24000}, 100000},

    // One tumbler inside the other, half way and all the way; then side by side.
    {4, "Close proximity test 1", kUpright, kUpright, {400, -300, 11000}, 1000},
    {4, "Close proximity test 2", kUpright, kUpright, {0, 0, 9000}, 1000},
    {4, "Close proximity test 3", kUpright, kUpsideDown, {-900, 16300, -3600}, 10000},

    {5, "Small proximity test 1", kUpright, kUpright, {24700, -2000, -300}, 10000},
    {5, "Small proximity test 2", kUpright, kLying, {-16500, -11000, -1800}, 10000},
    {5, "Small proximity test 3", kUpright, kUpsideDown, {22200, 500, 5200}, 10000},

    {6, "Sub 0: 796 faces", upright(0), upright(0), kIntersecting, 1000},
    {6, "Sub 1: 3184 faces", upright(1), upright(1), kIntersecting, 1000},
    {6, "Sub 2: 12736 faces", upright(2), upright(2), kIntersecting, 1000},
    {6, "Sub 3: 50944 faces", upright(3), upright(3), kIntersecting, 1000},
    {6, "Sub 4: 203776 faces", upright(4), upright(4), kIntersecting, 1000},

    {7, "Different sizes", kTenth, kUpright, kInTheWall, 1000},

    {8, "Different levelled objects, largest first", upright(4), kUpright, kIntersecting, 1000},
    {8, "Different levelled objects, smallest first", kUpright, upright(4), kIntersecting, 1000},
}};

const char* table_title(std::uint32_t table) {
  constexpr const char* kTitles[] = {"Intersection",
                                     "Separation",
                                     "Close proximity",
                                     "Small proximity",
                                     "Scalability",
                                     "Objects of different sizes",
                                     "Objects with different number of primitives"};
  return kTitles[table - kFirstTable];
}

}  // namespace flashbvh::scene
