// A page about images: what `flashbvh report` writes.
#ifndef FLASHBVH_TOOLS_REPORT_PAGE_HPP
#define FLASHBVH_TOOLS_REPORT_PAGE_HPP

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "evaluate/needed_work.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// A period of a core.
struct Budget {
  Core core;
  double hz;   ///< periods a second
  double mhz;  ///< a million instructions a second: one a cycle

  double instructions() const { return mhz * 1e6 / hz; }  ///< of a period
};

struct ReportOptions {
  /// Of B in A's frame, as `collide` takes them. A file for two images; a folder with a file A-B
  /// for each queried pair; empty: random poses.
  std::string poses;
  std::size_t samples;  ///< random poses of each pair; 0: none
  Budget budget;
};

/// Called before each piece of work with its name and its share of the whole.
using OnStep = std::function<void(const std::string& what, double share)>;

/// One self-contained HTML file, the same bytes for the same images and poses whatever their
/// folder. UserError as source_triangles() and read_lattice_poses(). At least one image.
std::string page_of(const std::vector<std::unique_ptr<ImageFile>>& images,
                    const ReportOptions& options, const OnStep& step);

}  // namespace flashbvh::tool

#endif
