// flashbvh_certified URDF --simplify METRES [--package NAME=FOLDER] [--visual-too] [--samples N]
//
// Samples the distance of a robot's simplified links from its own, against the certificate: points
// of either mesh, half of them random, and all vertices, and their distances from the other mesh. A
// certificate below a sample is wrong; one above 1.1 times the farthest is loose. Triangle counts
// are compared with the simplifier's own, for an equal error.
#include <cstdio>

#include "described.hpp"
#include "drawn_mesh.hpp"
#include "robot/baked/bake_links.hpp"
#include "simplify/coarsening.hpp"
#include "support/arms/arms.hpp"
#include "text/parallel.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

constexpr double kLoose = 1.1;

struct Row {
  std::size_t triangles = 0;
  std::size_t coarse = 0;
  std::size_t believed = 0;  ///< by the simplifier alone
  double certified = 0;
  double sampled = 0;
};

/// Samples points uniformly by area.
class Sampler {
 public:
  explicit Sampler(const std::vector<FloatTriangle>& triangles) : triangles_(triangles) {
    for (const FloatTriangle& of : triangles) {
      const double area = std::sqrt(squared(cross(minus(of[1], of[0]), minus(of[2], of[0]))));
      sums_.push_back((sums_.empty() ? 0 : sums_.back()) + area);
    }
  }
  Vector3 point(Random& random) const {
    const double sum = real_between(random, 0, sums_.back());
    const auto found = std::lower_bound(sums_.begin(), sums_.end(), sum);
    const auto number =
        std::min<std::size_t>(static_cast<std::size_t>(found - sums_.begin()), sums_.size() - 1);
    double u = real_between(random, 0, 1);
    double v = real_between(random, 0, 1);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const FloatTriangle& of = triangles_[number];
    return plus(plus(of[0], u, minus(of[1], of[0])), v, minus(of[2], of[0]));
  }

 private:
  const std::vector<FloatTriangle>& triangles_;
  std::vector<double> sums_;
};

double farthest(const std::vector<FloatTriangle>& of, const DrawnMesh& to, long samples,
                Random& random) {
  double most = 0;
  for (const FloatTriangle& triangle : of) {
    for (const Vector3& corner : triangle) {
      most = std::max(most, to.distance_to(corner));
    }
  }
  const Sampler sampler(of);
  for (long i = 0; i < samples; ++i) {
    most = std::max(most, to.distance_to(sampler.point(random)));
  }
  return most;
}

Row certified(const tool::ModelLink& link, double cell, double limit, long samples) {
  Row row;
  simplify::Coarsening coarsening(link.mesh, cell);
  row.triangles = link.mesh.triangles.size();
  row.believed = coarsening.estimate(limit);
  coarsening.coarsen(std::max(limit, coarsening.rounding()));
  row.coarse = coarsening.triangle_count();
  row.certified = coarsening.deviation().most;
  const std::vector<FloatTriangle> original = triangles_of(link.mesh);
  const std::vector<FloatTriangle> coarse = triangles_of(coarsening.mesh());
  Random random(1);
  const double there = farthest(original, DrawnMesh(coarse), samples / 2, random);
  const double back = farthest(coarse, DrawnMesh(original), samples / 2, random);
  row.sampled = std::max(there, back);
  return row;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Samples how far simplified links are from the URDF's.");
  Described described;
  double limit = 0;
  long samples = 1'000'000;
  described.add_to(app);
  app.add_option("--simplify", limit)->required();
  app.add_option("--samples", samples);
  CLI11_PARSE(app, count, arguments);
  try {
    const tool::Model model = described.read();
    const double cell = tool::robot_cell(model, std::nullopt, described.urdf);
    std::vector<Row> rows(model.links.size());
    tool::for_each_in_parallel(rows.size(), [&](std::size_t i) {
      rows[i] = certified(model.links[i], cell, limit, samples);
    });
    std::printf(
        "| link | triangles | certified | believed | certified, mm | sampled, mm | ratio |\n"
        "|---|--:|--:|--:|--:|--:|--:|\n");
    bool is_good = true;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Row& row = rows[i];
      const double ratio = row.sampled > 0 ? row.certified / row.sampled : 1;
      is_good = is_good && ratio >= 1 && ratio <= kLoose;
      std::printf("| %s | %zu | %zu | %zu | %.4f | %.4f | %.3f |\n", model.links[i].name.c_str(),
                  row.triangles, row.coarse, row.believed, 1000 * row.certified, 1000 * row.sampled,
                  ratio);
    }
    return is_good ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
