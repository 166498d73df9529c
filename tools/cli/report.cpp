// flashbvh report: a page to look at, with nothing in it that comes from elsewhere.
#include <memory>

#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "cli/progress.hpp"
#include "image/image_file.hpp"
#include "report/page.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

struct ReportArguments {
  std::vector<std::string> images;
  std::string page;
  std::size_t poses = 100;
};

void write_page(const ReportArguments& arguments) {
  refuse_to_replace_image(arguments.page);
  std::vector<std::unique_ptr<ImageFile>> images;
  for (const std::string& path : arguments.images) {
    images.push_back(std::make_unique<ImageFile>(path));
  }
  std::string page;
  {
    Progress progress(3.0 * static_cast<double>(images.size()), false);
    page = page_of(images, arguments.poses,
                   [&](const std::string& what, double share) { progress.begin(what, share); });
  }
  write_file(arguments.page, std::move(page));
}

}  // namespace

void add_report(CLI::App& app) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* const command = app.add_subcommand(
      "report",
      "Write a page about images: the mesh with its boxes, bytes by part, the tree's shape,\n"
      "warnings, and what queries cost.");
  command->add_option("IMAGE", arguments->images, "Images (.fbvh)")->required();
  command->add_option("-o,--output", arguments->page, "Page to write")
      ->required()
      ->type_name("PAGE.html");
  command
      ->add_option("--poses", arguments->poses,
                   "Random poses of each class about which a pair of images is asked; 0: none")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command->callback([arguments] { write_page(*arguments); });
}

}  // namespace flashbvh::tool
