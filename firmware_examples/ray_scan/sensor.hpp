// A time-of-flight sensor of 8 x 8 zones, 45 degrees wide: one ray through the centre of each zone.
#pragma once

#include <flashbvh/float.hpp>

constexpr int kSide = 8;
constexpr int kZones = kSide * kSide;

/// The distance of a zone without an echo within the reach, in millimetres.
constexpr uint16_t kNothing = 0;

/// A sensor's position in millimetres and its orientation, in the room's frame. `forward` and `up`
/// are perpendicular and of length 1.
struct Place {
  const char* name;
  float at[3];
  float forward[3];
  float up[3];
};

/// The rays of a sensor at one place; the reach is in millimetres.
class Sensor {
 public:
  static constexpr float kReach = 4000;

  Sensor(const Place& place, float cells_per_mm)
      : place_(place),
        right_{component_of_right(1, 2), component_of_right(2, 0), component_of_right(0, 1)},
        cells_per_mm_(cells_per_mm) {}

  /// Zones are numbered row by row from the upper left corner, as the sensor sees it.
  flashbvh::MadeSegment ray(int zone) const {
    const float right = kZone * (static_cast<float>(zone % kSide) - kMiddle);
    const float up = kZone * (kMiddle - static_cast<float>(zone / kSide));
    float direction[3];
    for (int i = 0; i < 3; ++i) {
      direction[i] = place_.forward[i] + right * right_[i] + up * place_.up[i];
    }
    return flashbvh::segment_of(place_.at, direction, kReach, cells_per_mm_);
  }

 private:
  static constexpr float kMiddle = (kSide - 1) / 2.0f;
  /// A zone's width at distance 1: 0.41421356 is the tangent of 45 / 2 degrees.
  static constexpr float kZone = 2 * 0.41421356f / kSide;

  float component_of_right(int i, int j) const {
    return place_.forward[i] * place_.up[j] - place_.forward[j] * place_.up[i];
  }

  const Place& place_;
  float right_[3];
  float cells_per_mm_;
};
