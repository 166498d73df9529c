// What queries at some poses needed, in work and in instructions.
#ifndef FLASHBVH_TOOLS_CLI_SUMMARY_HPP
#define FLASHBVH_TOOLS_CLI_SUMMARY_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "image/image_file.hpp"

namespace flashbvh::tool {

/// Prints the mean, the 99th percentile and the most of the poses' work, and how many instructions
/// that takes each core at most, which is proven of `ranked` alone. `work`: of each pose, not
/// empty.
void print_summary(const ImageFile& a, const ImageFile& b, const std::string& algorithm,
                   const std::vector<std::uint64_t>& work, bool json);

}  // namespace flashbvh::tool

#endif
