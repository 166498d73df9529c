// The part of a page about what queries cost.
#ifndef FLASHBVH_TOOLS_REPORT_QUERY_SECTION_HPP
#define FLASHBVH_TOOLS_REPORT_QUERY_SECTION_HPP

#include <string>
#include <utility>
#include <vector>

#include "report/subject.hpp"

namespace flashbvh::report {

/// Subjects that are asked about each other.
using SubjectPair = std::pair<const Subject*, const Subject*>;

/// Each with itself, then the first few pairs that can meet.
std::vector<SubjectPair> asked_pairs(const std::vector<const Subject*>& subjects);

/// A table for a pair.
std::string pair_section(const SubjectPair& pair, std::size_t poses);

/// What the tables mean and which pairs are left out.
std::string query_note(const std::vector<const Subject*>& subjects, std::size_t poses);

}  // namespace flashbvh::report

#endif
