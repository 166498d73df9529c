#include "live/live_section.hpp"
#include "mesh/units.hpp"
#include "report/html.hpp"
#include "report/page.hpp"
#include "report/standing.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The largest number of poses that the page can step through; beyond it, poses are skipped.
constexpr std::size_t kMostSteps = 2000;

bool can_be_live(const Subject& subject) {
  return std::holds_alternative<MeshWithLevels>(subject.image.tree());
}

LiveMesh live_mesh(const Subject& subject) {
  const ImageFile& image = subject.image;
  LiveMesh mesh = {subject.name,
                   {image.bytes(), static_cast<std::size_t>(subject.flash)},
                   unit_name(image.unit()),
                   {}};
  for (const Warning& warning : subject.warnings) {
    mesh.marks.push_back(warning.marks);
  }
  return mesh;
}

/// With the first given pose of each `step`, or the first of them that touches.
LivePair live_pair(const QueriedPair& pair, std::size_t a, std::size_t b, std::size_t step) {
  LivePair live = {a, b, {}, {}, ""};
  const std::string verdicts = pair.costs.are_given ? verdicts_of(pair.standings) : "";
  for (std::size_t first = 0; first < verdicts.size(); first += step) {
    const std::size_t touching = verdicts.substr(first, step).find('3');
    const std::size_t pose = first + (touching == std::string::npos ? 0 : touching);
    live.poses.push_back(line_of(pair.costs.poses[pose].pose, pair.a->image.cell()));
    live.names.push_back(concat("pose ", pose));
    live.verdicts += verdicts[pose];
  }
  return live;
}

}  // namespace

std::string live_part(const Subjects& subjects, std::vector<QueriedPair>& pairs) {
  std::vector<LiveMesh> meshes;
  std::string others;
  std::vector<std::size_t> places(subjects.size(), kMostLiveMeshes);
  for (const Subject* const subject : subjects) {
    if (has_live_section() && can_be_live(*subject) && meshes.size() < kMostLiveMeshes) {
      places[subject->number] = meshes.size();
      meshes.push_back(live_mesh(*subject));
    } else {
      others += (others.empty() ? "" : ", ") + escaped(subject->name);
    }
  }
  std::size_t poses = 0;
  for (const QueriedPair& pair : pairs) {
    poses += pair.standings.size();
  }
  std::vector<LivePair> live;
  for (QueriedPair& pair : pairs) {
    const std::size_t a = places[pair.a->number];
    const std::size_t b = places[pair.b->number];
    if (a < meshes.size() && b < meshes.size()) {
      pair.live = live.size();
      live.push_back(live_pair(pair, a, b, poses / kMostSteps + 1));
    }
  }
  const std::size_t alone = live.size();
  const bool is_alone = subjects.size() == 1 || live.empty();
  return live_section(meshes, live, is_alone ? alone : costliest(pairs).live.value_or(0)) +
         (others.empty() || !has_live_section()
              ? ""
              : note(concat("In three dimensions the page shows the first ", kMostLiveMeshes,
                            " post-indexed images with 16-bit indices, so not: ", others)));
}

}  // namespace flashbvh::tool
