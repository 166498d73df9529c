// Any bytes must be refused, or every query on them reads nothing else and ends.
//
// The bytes are opened in a heap block of exactly their size, so that the address sanitizer detects
// each access beyond them. A query ends within as many visits as there are pairs of nodes: all
// traversals but `leaf` visit a pair at most once, and `leaf` visits pairs of a leaf and a node.
#pragma once

#include <cstddef>
#include <vector>

#include "flashbvh/pose.hpp"

namespace flashbvh::test {

/// `wrong`: nullptr, or a description of the failure.
struct Verdict {
  bool opened = false;
  const char* wrong = nullptr;
};

/// Opens `size` bytes as an image of each kind. If it opens, every traversal runs in every pose,
/// against itself and against a golden image, in both orders.
Verdict exercise_image(const void* bytes, std::size_t size, const std::vector<Pose>& poses);

/// Corrects the checksum of an image, if the bytes have a header.
void repair_crc(void* bytes, std::size_t size);

/// Poses translated, rotated, far away; and poses that are errors.
std::vector<Pose> representative_poses();

}  // namespace flashbvh::test
