#include "report/pictures.hpp"

#include "report/box_lines.hpp"
#include "report/html.hpp"
#include "report/png.hpp"

namespace flashbvh::report {
namespace {

/// The level that is shown at first: the deepest of few boxes.
constexpr std::size_t kFewBoxes = 20;

std::size_t first_choice(const std::vector<Level>& levels) {
  std::size_t choice = 0;
  while (choice + 1 < levels.size() && levels[choice + 1].boxes.size() <= kFewBoxes) {
    ++choice;
  }
  return choice;
}

std::string radio(const Subject& subject, const std::string& value, const std::string& label,
                  bool checked) {
  const std::string group = "v" + std::to_string(subject.number);
  const std::string id = group + "-" + value;
  return "<input type=radio name=" + group + " id=" + id + " class=\"R R" + value + "\"" +
         (checked ? " checked" : "") + "><label for=" + id + ">" + label + "</label>\n";
}

/// What the level shown consists of. `place`: in the list of levels, which the style counts by.
std::string level_note(const Level& level, std::size_t place) {
  std::size_t leaves = 0;
  for (const NodeBox& box : level.boxes) {
    leaves += box.is_leaf ? 1 : 0;
  }
  return "<span class=\"L L" + std::to_string(place) + "\">Level " + std::to_string(level.depth) +
         ": " + counted(level.boxes.size(), "box", "boxes") +
         (leaves == 0 ? ""
                      : ", " + grouped(leaves) + (leaves == 1 ? " a leaf" : " of them leaves")) +
         ". </span>\n";
}

std::string drawing(const Subject& subject, const View& view, const std::vector<Level>& levels) {
  const std::string side = std::to_string(kDrawingSide);
  std::string svg = "<figure><svg viewBox=\"0 0 " + side + " " + side +
                    "\" role=img aria-label=\"" + escaped(subject.name) + ", " + view.name + ": " +
                    view.caption + ", with the boxes of the level chosen\">\n<image width=" + side +
                    " height=" + side + " href=\"" +
                    data_uri(picture_of(subject.triangles, view, subject.box)) + "\"/>\n";
  for (std::size_t i = 0; i < levels.size(); ++i) {
    svg += box_lines(levels[i], i, view, subject.box);
  }
  return svg + "</svg><figcaption><b>" + view.name + "</b> " + view.caption +
         "</figcaption></figure>\n";
}

}  // namespace

std::string pictures(const Subject& subject) {
  const std::vector<Level> levels = drawn_levels(subject.image.tree(), subject.shape);
  const std::size_t first = first_choice(levels);
  std::string html =
      "<fieldset class=look><legend>Boxes of level</legend>\n" + radio(subject, "n", "none", false);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    html += radio(subject, std::to_string(i), std::to_string(levels[i].depth), i == first);
  }
  html += "<p class=note>";
  for (std::size_t i = 0; i < levels.size(); ++i) {
    html += level_note(levels[i], i);
  }
  if (levels.size() != subject.shape.nodes_by_depth.size()) {
    html += "Drawn are up to " + std::to_string(kMostLevels) + " levels of up to " +
            std::to_string(kMostBoxes) + " boxes.";
  }
  html += "</p>\n<div class=views>\n";
  for (const View& view : views()) {
    html += drawing(subject, view, levels);
  }
  return html + "</div></fieldset>\n";
}

std::string picture_style() {
  std::string style = ".L{display:none}\n";
  for (std::size_t i = 0; i < kMostLevels; ++i) {
    const std::string place = std::to_string(i);
    style.append(i == 0 ? ".R" : ",.R").append(place).append(":checked~* .L").append(place);
  }
  return style + "{display:inline}\n";
}

}  // namespace flashbvh::report
