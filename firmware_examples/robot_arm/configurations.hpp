// The configurations that the example tests.
#pragma once

#include "joints.hpp"

struct Configuration {
  const char* name;
  int degrees[kJointCount];  ///< from the base to the palm
};

constexpr float radians(int degrees) {
  return static_cast<float>(degrees) * 0.0174532925f;
}

constexpr Configuration kConfigurations[] = {
    {"home", {0, 0, 0, 0, 0, 0}},
    {"reaching", {30, 60, -40, 0, 30, 0}},
    {"picking", {-45, 80, -60, 90, 60, 45}},
    {"tucked", {0, -45, -185, 0, 75, 0}},
    {"wrist_bent_back", {120, 20, -60, -30, -105, 90}},
    {"leaning_back", {0, -90, -140, 0, 90, 0}},
    {"folded", {0, -85, -185, 0, -45, 0}},
    {"bowed_down", {0, 115, 45, 0, 70, 0}},
};

/// True if the joint limits of the arm allow it.
constexpr bool is_allowed(const Configuration& configuration) {
  for (int i = 0; i < kJointCount; ++i) {
    const float angle = radians(configuration.degrees[i]);
    if (angle < kJoints[i].least || angle > kJoints[i].most) {
      return false;
    }
  }
  return true;
}

constexpr bool all_are_allowed() {
  for (const Configuration& configuration : kConfigurations) {
    if (!is_allowed(configuration)) {
      return false;
    }
  }
  return true;
}
static_assert(all_are_allowed(), "a configuration beyond the joints' limits");
