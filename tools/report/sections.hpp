// The parts of a page.
#ifndef FLASHBVH_TOOLS_REPORT_SECTIONS_HPP
#define FLASHBVH_TOOLS_REPORT_SECTIONS_HPP

#include <string>
#include <utility>
#include <vector>

#include "report/subject.hpp"

namespace flashbvh::tool {

/// Key figures, pictures, bytes, shape, rounding and warnings.
std::string image_section(const Subject& subject);

/// A row for each image.
std::string summary(const std::vector<const Subject*>& subjects);

/// Four views and a choice of levels, which works by style alone.
std::string pictures(const Subject& subject);

/// What the style needs for the choice.
std::string picture_style();

/// Subjects that are asked about each other.
using SubjectPair = std::pair<const Subject*, const Subject*>;

/// Each with itself, then the first few pairs that can be queried.
std::vector<SubjectPair> asked_pairs(const std::vector<const Subject*>& subjects);

/// A table for a pair.
std::string pair_section(const SubjectPair& pair, std::size_t poses);

/// What the tables mean and which pairs are left out.
std::string query_note(const std::vector<const Subject*>& subjects, std::size_t poses);

}  // namespace flashbvh::tool

#endif
