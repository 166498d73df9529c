#include "report/page.hpp"

#include <algorithm>

#include "report/html.hpp"
#include "report/sections.hpp"
#include "report/style.hpp"
#include "report/subject.hpp"

namespace flashbvh::tool {
namespace {

/// `title` is HTML.
std::string head(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n"
         "<meta name=viewport content=\"width=device-width,initial-scale=1\">\n<title>" +
         title + " &middot; flashbvh report</title>\n<style>\n" + kColours + kText + kTables +
         kPictures + picture_style() + "</style>\n</head>\n<body>\n";
}

std::string title_of(const std::vector<const Subject*>& subjects) {
  return subjects.size() == 1 ? escaped(subjects[0]->name)
                              : counted(subjects.size(), "mesh", "meshes");
}

std::string opening(const std::vector<const Subject*>& subjects) {
  return "<header>\n<h1>flashbvh report</h1>\n<p class=lead>What <code>flashbvh bake</code> made: "
         "the collision geometry with the boxes over it, its bytes, and what queries "
         "cost.</p>\n</header>\n<main>\n" +
         (subjects.size() == 1
              ? ""
              : "<section>\n" + summary(subjects) +
                    "<p><a href=\"#queries\">What queries cost</a></p></section>\n");
}

std::string queries(const std::vector<const Subject*>& subjects, std::size_t poses,
                    const Step& step) {
  if (poses == 0) {
    return "";
  }
  std::string html = "<section id=queries>\n<h2>What queries cost</h2>\n" +
                     query_note(subjects, poses) + "<div class=pairs>\n";
  for (const SubjectPair& pair : asked_pairs(subjects)) {
    step("querying " + pair.first->name + " and " + pair.second->name, 1);
    html += pair_section(pair, poses);
  }
  return html + "</div>\n</section>\n";
}

}  // namespace

std::string page_of(const std::vector<std::unique_ptr<ImageFile>>& images, std::size_t poses,
                    const Step& step) {
  std::vector<std::string> paths(images.size());
  std::transform(images.begin(), images.end(), paths.begin(),
                 [](const auto& image) { return image->path(); });
  const std::vector<std::string> names = unique_names(paths);
  std::vector<std::unique_ptr<Subject>> owned;
  std::vector<const Subject*> subjects;
  for (std::size_t i = 0; i < images.size(); ++i) {
    owned.push_back(std::make_unique<Subject>(*images[i], i, names[i]));
    subjects.push_back(owned.back().get());
  }
  std::string html = head(title_of(subjects)) + opening(subjects);
  for (const Subject* const subject : subjects) {
    step("drawing " + subject->name, 1);
    html += image_section(*subject);
  }
  return html + queries(subjects, poses, step) + "</main>\n</body>\n</html>\n";
}

}  // namespace flashbvh::tool
