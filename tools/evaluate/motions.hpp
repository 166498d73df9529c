// Motions of a body, as text in the mesh's unit, and their first contacts.
#pragma once

#include <cstdint>
#include <string>

#include "flashbvh/first_contact.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// A pose from an option's value: 12 numbers, or 3, a translation. UserError, naming the option, if
/// it is none.
Pose read_pose_argument(const std::string& given, double cell, const std::string& option);

struct FoundContact : FirstContactAnswerOf<std::uint32_t> {
  std::uint32_t close_distance;  ///< FirstContact::close_distance()
};

/// The outcome of a motion. Both images are post-indexed partners. UserError, naming `--to`, if the
/// library refuses the motion.
FoundContact first_contact(const ImageFile& a, const ImageFile& b, const BodyMotion& motion,
                           FineLength within);

/// "free", "contact" or "close".
const char* outcome_name(ContactOutcome outcome);

/// A time as a part of the motion; 1 is its end.
inline double share_of(std::uint32_t time) {
  return static_cast<double>(time) / kMotionEnd;
}

}  // namespace flashbvh::tool
