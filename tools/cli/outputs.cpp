#include "cli/outputs.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "flashbvh/image.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

void refuse_to_replace_inputs(const std::string& output, const std::vector<std::string>& inputs) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(output, error)) {
    return;
  }
  for (const std::string& input : inputs) {
    if (std::filesystem::equivalent(output, input, error)) {
      throw UserError(output, "would replace ", input, ", which is read; write elsewhere");
    }
  }
}

void check_output(const std::string& output, const std::vector<std::string>& inputs) {
  refuse_to_replace_inputs(output, inputs);
  std::uint32_t magic = 0;
  std::error_code error;
  if (!std::filesystem::is_regular_file(output, error)) {
    return;
  }
  std::ifstream file(output, std::ios::binary);
  file.read(reinterpret_cast<char*>(&magic), sizeof magic);
  if (file && magic == kImageMagic) {
    throw UserError(output, "is an image, which would be replaced; write elsewhere");
  }
}

}  // namespace flashbvh::tool
