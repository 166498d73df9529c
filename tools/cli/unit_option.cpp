#include "cli/commands.hpp"
#include "mesh/units.hpp"

namespace flashbvh::tool {

void add_unit_option(CLI::App& command, std::vector<std::string>& given) {
  command
      .add_option("--unit", given,
                  "Unit of the meshes and of all other lengths, given and printed: " +
                      std::string(kUnitNames) +
                      ".\nFILE=UNIT: this file alone is in another unit and is converted. "
                      "May be repeated. Default: numbers as they are")
      ->type_name("UNIT|FILE=UNIT")
      ->type_size(1)
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace flashbvh::tool
