#include "report/page.hpp"

#include <algorithm>

#include "report/html.hpp"
#include "report/sections.hpp"
#include "report/subject.hpp"

namespace flashbvh::tool {
namespace {

std::string title_of(const Subjects& subjects) {
  if (subjects.size() > 2) {
    return counted(subjects.size(), "mesh", "meshes");
  }
  return escaped(subjects[0]->name) +
         (subjects.size() == 1 ? "" : " and " + escaped(subjects[1]->name));
}

std::size_t most_levels(const Subjects& subjects) {
  std::size_t levels = 0;
  for (const Subject* const subject : subjects) {
    levels = std::max(levels, subject->levels.size());
  }
  return levels;
}

}  // namespace

std::string page_of(const std::vector<std::unique_ptr<ImageFile>>& images,
                    const ReportOptions& options, const Step& step) {
  std::vector<std::string> paths(images.size());
  std::transform(images.begin(), images.end(), paths.begin(),
                 [](const auto& image) { return image->path(); });
  const std::vector<std::string> names = unique_names(paths);
  std::vector<std::unique_ptr<Subject>> owned;
  Subjects subjects;
  for (std::size_t i = 0; i < images.size(); ++i) {
    owned.push_back(std::make_unique<Subject>(*images[i], i, names[i]));
    subjects.push_back(owned.back().get());
  }
  const std::vector<AskedPair> pairs = asked_pairs(subjects, options, step);
  std::string html = fit_section(subjects, pairs, options) +
                     pairs_section(subjects, pairs, options) + flash_table(subjects);
  for (const Subject* const subject : subjects) {
    step("drawing " + subject->name, 1);
    html += image_section(*subject);
  }
  return page(title_of(subjects), "report", "flash, RAM and time",
              level_style(most_levels(subjects)), html + foot(subjects));
}

}  // namespace flashbvh::tool
