// Python's poses: homogeneous matrices.
#pragma once

#include <string>

#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"
#include "python/arrays.hpp"

namespace flashbvh::python {

/// A name for messages, such as "poses[3]".
std::string place_of(const char* argument, std::size_t number);

/// Poses of B in A's frame, as floats like firmware's: (4, 4) or (N, 4, 4).
class Poses {
 public:
  explicit Poses(const py::object& given, const char* name = "poses");

  std::size_t size() const { return matrices_.count; }
  const Shape& shape() const { return matrices_.shape; }
  /// The pose for images of this cell; `cells`: cells_per_unit(). Runs without Python's lock.
  /// UserError if the library refuses it.
  Pose at(std::size_t number, double cell, float cells) const;

 private:
  const char* name_;
  Numbers matrices_;
};

}  // namespace flashbvh::python
