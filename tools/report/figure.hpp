// A picture in a page: faces, lines over them, axes and a scale below.
#ifndef FLASHBVH_TOOLS_REPORT_FIGURE_HPP
#define FLASHBVH_TOOLS_REPORT_FIGURE_HPP

#include <string>

#include "image/image_file.hpp"
#include "report/drawing.hpp"

namespace flashbvh::tool {

/// " mm", or nothing where an image does not tell its unit.
std::string unit_suffix(const ImageFile& image);

/// A length, given in the mesh's unit, to four digits, with the unit.
std::string length_of(const ImageFile& image, double length);

/// A cell, in a unit, and what stands behind lengths in it: " mm".
struct Measure {
  double cell;
  std::string suffix;
};
Measure measure_of(const ImageFile& image);

/// `label`: what is seen, for who can't see it; `overlay`: SVG in units of the drawing; `caption`.
/// All three HTML. `measure`: of the scale.
std::string figure(const Faces& faces, const Frame& frame, const Measure& measure,
                   const std::string& label, const std::string& overlay,
                   const std::string& caption);

}  // namespace flashbvh::tool

#endif
