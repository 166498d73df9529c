// What must hold of any bytes: they are refused, or every query on them reads nothing else and
// ends.
//
// The bytes are opened in a heap block of exactly their size, so that the address sanitizer sees
// each access beyond them. A query ends within as many visits as there are pairs of nodes: all
// traversals but `leaf` visit a pair at most once, and `leaf` visits pairs of a leaf and a node.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "flashbvh/pose.hpp"

namespace flashbvh::test {

/// Nothing wrong: nullptr; else what.
struct Verdict {
  bool opened = false;
  const char* wrong = nullptr;
};

/// Opens `size` bytes as an image of each kind. On what opens, every traversal runs in every pose,
/// against itself and against a golden image, both ways.
Verdict exercise_image(const void* bytes, std::size_t size, const std::vector<Pose>& poses);

/// Sets the checksum of an image to what it must be, if there is a header to hold it.
void repair_crc(void* bytes, std::size_t size);

/// Translated, rotated, far away; and poses that are errors.
std::vector<Pose> telling_poses();

}  // namespace flashbvh::test
