// A page about images: what `flashbvh report` writes.
#ifndef FLASHBVH_TOOLS_REPORT_PAGE_HPP
#define FLASHBVH_TOOLS_REPORT_PAGE_HPP

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "image/image_file.hpp"

namespace flashbvh::tool {

/// Told before each piece of work: what it is about, and which share of the whole it is.
using Step = std::function<void(const std::string& what, double share)>;

/// One self-contained HTML file, the same bytes for the same images whatever their folder. `poses`:
/// of each pair's sample. UserError as source_triangles(). At least one image.
std::string page_of(const std::vector<std::unique_ptr<ImageFile>>& images, std::size_t poses,
                    const Step& step);

}  // namespace flashbvh::tool

#endif
