// The parts of a page.
#ifndef FLASHBVH_TOOLS_REPORT_SECTIONS_HPP
#define FLASHBVH_TOOLS_REPORT_SECTIONS_HPP

#include <string>
#include <vector>

#include "report/page.hpp"
#include "report/pose_costs.hpp"
#include "report/subject.hpp"

namespace flashbvh::tool {

using Subjects = std::vector<const Subject*>;

/// Two subjects that are queried against each other, the second moving.
struct QueriedPair {
  const Subject* a;
  const Subject* b;
  PairCosts costs;
};

/// "ring and peg", as HTML.
std::string title_of(const QueriedPair& pair);

/// The pair whose costliest pose, or bound where there are no poses, takes most work.
const QueriedPair& costliest(const std::vector<QueriedPair>& pairs);

/// Flash, RAM and time, and whether they are enough. `pairs`: may be none.
std::string fit_section(const Subjects& subjects, const std::vector<QueriedPair>& pairs,
                        const ReportOptions& options);

/// The worst of each pair as a matrix, for three meshes or more; the costliest pose and a first
/// contact as pictures; work by how close the meshes come. Nothing without poses.
std::string pairs_section(const Subjects& subjects, const std::vector<QueriedPair>& pairs,
                          const ReportOptions& options);

/// Key figures, pictures and warnings.
std::string image_section(const Subject& subject);

/// Four views and a choice of levels, which works by style alone.
std::string pictures(const Subject& subject);
/// What the style needs for the choice among so many levels.
std::string level_style(std::size_t levels);

/// Flash by mesh and part, on one scale.
std::string flash_table(const Subjects& subjects);

/// The version, and how each image was baked.
std::string foot(const Subjects& subjects);

}  // namespace flashbvh::tool

#endif
