// What must hold of any bytes as a robot's image: they are refused, or a guard and a motion query
// of the robot read nothing else and end.
//
// The bytes are opened in a heap block of exactly their size, so that the address sanitizer sees
// each access beyond them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "flashbvh/robot/image.hpp"

namespace flashbvh::test {

/// `wrong`: nullptr; else what.
struct RobotVerdict {
  Status status;
  const char* wrong = nullptr;
};

/// Opens `size` bytes; of a robot that opens, a guard gets some values and a motion certified,
/// made of `number`: any numbers.
RobotVerdict exercise_robot(const void* bytes, std::size_t size,
                            const std::function<std::uint32_t()>& number);

/// Sets the checksum and, where the rest is good, the hash to what they must be.
void repair_robot(void* bytes, std::size_t size);

}  // namespace flashbvh::test
