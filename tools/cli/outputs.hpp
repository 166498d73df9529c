// What a slip of the command line must not cost.
#ifndef FLASHBVH_TOOLS_CLI_OUTPUTS_HPP
#define FLASHBVH_TOOLS_CLI_OUTPUTS_HPP

#include <string>
#include <vector>

namespace flashbvh::tool {

/// UserError if the file `output` is one of `inputs`, by whatever name.
void refuse_to_replace_inputs(const std::string& output, const std::vector<std::string>& inputs);

/// For commands that write no image: UserError as above, or if the file `output` is an image. It
/// may be empty: no file.
void check_output(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace flashbvh::tool

#endif
