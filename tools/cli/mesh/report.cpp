// flashbvh report: writes a page that shows queries on meshes and needs no other files.
#include <filesystem>
#include <memory>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "image/image_file.hpp"
#include "report/page.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct ReportArguments {
  std::vector<std::string> images;
  std::string page;
  std::string core = "Cortex-M4F";
  ReportOptions options = {"", 400, {{}, 1000, 168}};
};

/// The file of poses, or all files that the folder contains.
std::vector<std::string> poses_read(const std::string& poses) {
  std::vector<std::string> read = {poses};
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(poses, error)) {
    read.push_back(entry.path().string());
  }
  return read;
}

void write_page(ReportArguments& arguments) {
  for (const Core& core : cores_in_cycles()) {
    if (arguments.core == core.name) {
      arguments.options.budget.core = core;
    }
  }
  check_output(arguments.page, poses_read(arguments.options.poses));
  std::vector<std::unique_ptr<ImageFile>> images;
  for (const std::string& path : arguments.images) {
    images.push_back(std::make_unique<ImageFile>(path));
  }
  std::string page;
  {
    Progress progress(2.0 * static_cast<double>(images.size()), false);
    page = page_of(images, arguments.options,
                   [&](const std::string& what, double share) { progress.begin(what, share); });
  }
  write_file(arguments.page, std::move(page));
}

/// The error message unless the text is a number from 0.001 to 1e9.
std::string refuse_rate(const std::string& text) {
  const std::optional<double> rate = parse_number(text);
  return rate && *rate >= 1e-3 && *rate <= 1e9 ? "" : "must be a number from 0.001 to 1e9";
}

void add_budget(CLI::App& command, ReportArguments& arguments) {
  std::vector<std::string> names;
  for (const Core& core : cores_in_cycles()) {
    names.emplace_back(core.name);
  }
  Budget& budget = arguments.options.budget;
  command
      .add_option("--core", arguments.core,
                  "Core whose proven cycles are taken, or instructions if there are none; Fast: "
                  "MULS takes a cycle")
      ->transform(CLI::IsMember(names, CLI::ignore_case))
      ->capture_default_str();
  command.add_option("--hz", budget.hz, "Periods a second")
      ->check(refuse_rate, "NUMBER")
      ->capture_default_str();
  add_clock(command, budget.mhz, "The core's clock")->default_str("168MHz");
  add_flash(command, budget.flash);
}

}  // namespace

void add_report(CLI::App& app) {
  auto [command, a] = add_command<ReportArguments>(
      app, "report",
      "Write a page to decide by: whether meshes touch, as one moves them in it; whether images "
      "fit\n"
      "a firmware's flash, RAM and period; and what queries about them cost.",
      write_page);
  ReportOptions& options = a.options;
  add_image(command, a.images, "FILE.fbvh", "Images (.fbvh)");
  add_option(command, "-o,--output", a.page, "PAGE.html", "Page to write")->required();
  CLI::Option* const poses =
      add_option(command, "--poses", options.poses, "FILE",
                 "Poses of the second image in the first one's frame, as `collide` takes "
                 "them; for more images a folder with a file A-B for each pair")
          ->check([](const std::string& path) { return path.empty() ? "names no file" : ""; });
  command
      .add_option("--samples", options.samples,
                  "Without --poses: random poses of each pair; 0: none")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str()
      ->excludes(poses);
  add_budget(command, a);
  add_example(command, "report baked/plate.fbvh baked/peg.fbvh --poses poses.txt -o fit.html",
              "writes the page fit.html");
}

}  // namespace flashbvh::tool
