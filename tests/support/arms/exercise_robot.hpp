// Any bytes as a robot's image must be refused, or a guard and a motion query of the robot read
// nothing else and end.
//
// The bytes are opened in a heap block of exactly their size, so that the address sanitizer
// detects each access beyond them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "flashbvh/robot/image.hpp"

namespace flashbvh::test {

/// `wrong`: nullptr, or a description of the failure.
struct RobotVerdict {
  Status status;
  const char* wrong = nullptr;
};

/// Opens `size` bytes. If they open, a guard and a motion query of the robot get values made of any
/// numbers that `number` returns.
RobotVerdict exercise_robot(const void* bytes, std::size_t size,
                            const std::function<std::uint32_t()>& number);

/// Corrects the checksum and, if the other fields are valid, the hash.
void repair_robot(void* bytes, std::size_t size);

}  // namespace flashbvh::test
