// flashbvh report: writes a page in which meshes answer.
#include <algorithm>
#include <map>
#include <memory>

#include "cli/commands.hpp"
#include "cli/mesh/image_facts.hpp"
#include "cli/page.hpp"
#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "image/mesh_warnings.hpp"
#include "mesh/units.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The largest number of pairs in a page: all pairs of twelve meshes.
constexpr std::size_t kMostPairs = 66;
/// The largest number of poses that a page steps through; beyond it, poses are skipped.
constexpr std::size_t kMostSteps = 2000;

struct ReportArguments {
  std::vector<std::string> images;
  std::string page;
  std::string poses;
};

using Images = std::vector<std::unique_ptr<ImageFile>>;

/// Names of the image files; equal names get numbers.
std::vector<std::string> unique_names(const Images& images) {
  std::map<std::string, std::size_t> seen;
  std::vector<std::string> names;
  for (const auto& image : images) {
    const std::size_t before = seen[image->name()]++;
    names.push_back(before == 0 ? image->name() : concat(image->name(), " (", before + 1, ")"));
  }
  return names;
}

/// True if the surfaces intersect, or one mesh is inside the other.
bool touches(const ImageFile& a, const ImageFile& b, const Pose& pose, std::size_t number) {
  const Answer answer = collide(a.tree(), b.tree(), pose, true);
  check_answered(answer, b.path(), number);
  return answer.counts.triangle_pairs != 0 || one_is_inside(a, b, pose).value_or(false);
}

/// Two images at their poses, of which so many touch. The page steps through some of them.
struct QueriedPair {
  std::size_t a;
  std::size_t b;
  Json drawn_poses;  ///< of 12 numbers each
  Json names;
  std::string verdicts;  ///< a digit each
  std::size_t touching;
  std::size_t poses;
};

/// At the poses of a file, or as drawn. Of each few poses the page steps to one, one that touches.
QueriedPair queried_pair(const Images& images, std::size_t a, std::size_t b,
                         const std::string& path) {
  const double cell = images[a]->cell();
  const std::vector<Pose> poses =
      path.empty() ? std::vector<Pose>{Pose::translated(0, 0, 0)} : read_lattice_poses(path, cell);
  QueriedPair pair = {a, b, Json::array(), Json::array(), "", 0, poses.size()};
  const std::size_t step = poses.size() / kMostSteps + 1;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool touch = touches(*images[a], *images[b], poses[i], i);
    pair.touching += touch ? 1 : 0;
    if (path.empty()) {
      break;  // one pose needs no time line
    }
    if (i % step == 0) {
      pair.drawn_poses.emplace_back();
      pair.names.emplace_back();
      pair.verdicts += ' ';
    }
    if (i % step == 0 || (touch && pair.verdicts.back() == '0')) {
      pair.drawn_poses.back() = joined(pose_numbers(poses[i], cell), shortest, " ");
      pair.names.back() = concat("pose ", i);
      pair.verdicts.back() = touch ? '4' : '0';
    }
  }
  return pair;
}

/// All pairs that can be queried; with poses, the only one.
std::vector<QueriedPair> queried_pairs(const Images& images, const std::string& poses) {
  if (!poses.empty()) {
    if (images.size() > 2) {
      throw UserError(poses, "has poses of a second image in a first one's frame, and ",
                      images.size(), " are given; give two");
    }
    check_partners(*images.front(), *images.back());
    return {queried_pair(images, 0, images.size() - 1, poses)};
  }
  std::vector<QueriedPair> pairs;
  for (std::size_t a = 0; a < images.size(); ++a) {
    for (std::size_t b = a + 1; b < images.size() && pairs.size() < kMostPairs; ++b) {
      if (are_partners(*images[a], *images[b])) {
        pairs.push_back(queried_pair(images, a, b, ""));
      }
    }
  }
  return pairs;
}

Headline headline_of(const QueriedPair& pair, const std::vector<std::string>& names,
                     bool is_drawn) {
  const std::string& a = names[pair.a];
  const std::string& b = names[pair.b];
  return pair.touching == 0 ? Headline{0, concat(b, " does not touch ", a,
                                                 is_drawn ? ", as drawn" : " at any pose")}
                            : Headline{4, concat(b, " touches ", a,
                                                 is_drawn ? ", as drawn"
                                                          : concat(" at ", pair.touching, " of ",
                                                                   pair.poses, " poses"))};
}

/// A mesh of a page: its odd triangles and edges.
struct Subject {
  /// Of each a colour of the page, and vertices, of which two make a line.
  Json marks = Json::array();
  std::vector<std::string> warnings;  ///< without the image's name
};

/// `places`: indices in `sources`; the warning lists the triangles' numbers in the source mesh.
void mark_triangles(Subject& subject, const std::vector<SourceTriangle>& sources,
                    TriangleIds places, const char* colour, const char* what) {
  if (places.empty()) {
    return;
  }
  Json marks = Json::array();
  for (std::uint32_t& place : places) {
    const auto& [p, q, r] = sources[place].vertices;
    for (const std::uint32_t vertex : {p, q, q, r, r, p}) {
      marks.push_back(vertex);
    }
    place = sources[place].number;
  }
  subject.marks.push_back({colour, std::move(marks)});
  subject.warnings.push_back(triangle_list(places) + what);
}

void mark_edges(Subject& subject, const std::vector<OddEdge>& edges, EdgeDefect defect,
                const char* colour) {
  Json marks = Json::array();
  for (const auto& [vertices, found] : edges) {
    if (found == defect) {
      marks.push_back(vertices[0]);
      marks.push_back(vertices[1]);
    }
  }
  if (!marks.empty()) {
    subject.marks.push_back({colour, std::move(marks)});
  }
}

Subject subject_of(const ImageFile& image) {
  Subject subject;
  const std::vector<SourceTriangle> sources = source_triangles(image);
  const bake::LatticeMesh mesh = mesh_of(image, sources);
  const MeshDefects defects = surface_defects(mesh);
  mark_triangles(subject, sources, defects.duplicates, "--p1",
                 " with the three vertices of an earlier one");
  mark_triangles(subject, sources, degenerate_triangles(mesh), "--p4",
                 " without area: a segment or a point");
  const std::vector<OddEdge> edges = odd_edges(mesh.triangles, defects.duplicates);
  mark_edges(subject, edges, EdgeDefect::boundary, "--p0");
  mark_edges(subject, edges, EdgeDefect::non_manifold, "--p3");
  mark_edges(subject, edges, EdgeDefect::twisted, "--p2");
  Warnings of_surface;
  warn_of_surface(defects, "", of_surface);
  for (const PlacedWarning& warning : of_surface.all()) {
    subject.warnings.push_back(warning.what);
  }
  return subject;
}

void write_page(const ReportArguments& arguments) {
  check_output(arguments.page, {arguments.poses});
  Images images;
  for (const std::string& path : arguments.images) {
    images.push_back(std::make_unique<ImageFile>(path));
  }
  const std::vector<std::string> names = unique_names(images);
  std::vector<QueriedPair> pairs = queried_pairs(images, arguments.poses);
  std::vector<Headline> headlines;
  headlines.reserve(pairs.size());
  for (const QueriedPair& pair : pairs) {
    headlines.push_back(headline_of(pair, names, arguments.poses.empty()));
  }
  Json meshes = Json::array();
  Json facts = Json::array();
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const ImageFile& image = *images[i];
    const Subject subject = subject_of(image);
    for (const std::string& warning : subject.warnings) {
      headlines.push_back({1, names[i] + ": " + warning});
    }
    facts.push_back(image_facts(image));
    // The library in a page opens only images of this kind.
    const bool is_drawn =
        std::holds_alternative<MeshWithLevels>(image.tree()) && meshes.size() < kMostDrawn;
    places.push_back(is_drawn ? meshes.size() : kMostDrawn);
    if (is_drawn) {
      meshes.push_back({{"name", names[i]},
                        {"image", base64(image.bytes(), image.header().byte_count)},
                        {"unit", unit_name(image.unit())},
                        {"marks", subject.marks}});
    }
  }
  if (headlines.empty()) {
    headlines.push_back({0, "no surface has a defect"});
  }
  std::stable_sort(headlines.begin(), headlines.end(),
                   [](const Headline& p, const Headline& q) { return p.first > q.first; });
  auto& [verdict, first] = headlines.front();
  first = concat(verdict == 4   ? "Move apart: "
                 : verdict == 1 ? "Mend: "
                                : "Nothing to change: ",
                 first);
  Json drawn = Json::array();
  for (QueriedPair& pair : pairs) {
    if (places[pair.a] < kMostDrawn && places[pair.b] < kMostDrawn) {
      drawn.push_back({{"a", places[pair.a]},
                       {"b", places[pair.b]},
                       {"poses", std::move(pair.drawn_poses)},
                       {"names", std::move(pair.names)},
                       {"verdicts", std::move(pair.verdicts)}});
    }
  }
  const std::string title =
      names.size() > 2 ? concat(names.size(), " meshes") : joined(names, " and ");
  write_file(arguments.page,
             page_text("report", title, headlines, facts,
                       meshes.empty() ? Json() : Json{{"meshes", meshes}, {"pairs", drawn}}));
}

}  // namespace

void add_report(CLI::App& app) {
  auto [command, a] =
      add_command<ReportArguments>(app, "report",
                                   "Write a page in which meshes answer as one moves them: whether "
                                   "they touch, and how far apart "
                                   "they are.",
                                   write_page);
  add_option(command, "IMAGE", a.images, "FILE.fbvh", "Images (.fbvh)")->required();
  add_option(command, "-o,--output", a.page, "PAGE.html", "Page to write")->required();
  add_option(command, "--poses", a.poses, "FILE",
             "Poses of the second image in the first one's frame, as `collide` takes them")
      ->check([](const std::string& path) { return path.empty() ? "names no file" : ""; });
  add_example(command, "report baked/plate.fbvh baked/peg.fbvh --poses poses.txt -o fit.html",
              "writes the page fit.html");
}

}  // namespace flashbvh::tool
