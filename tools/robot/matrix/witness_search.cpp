#include "robot/matrix/witness_search.hpp"

#include <algorithm>
#include <cmath>

namespace flashbvh::tool {
namespace {

/// From how many places it goes downhill.
constexpr std::size_t kDescents = 16;
/// Steps begin at a quarter of the ranges and are halved so often.
constexpr int kHalvings = 14;
/// Of a descent, so that one along a valley ends.
constexpr int kMostSteps = 300;
/// Of deepened(), a part of the range.
constexpr double kFirstStep = 1.0 / (1 << 16);

struct Place {
  double distance;
  std::vector<double> point;
  Witness<std::uint16_t> hint;
};

/// Of `number` in base `base`, its digits mirrored at the point: in (0, 1).
double mirrored(std::uint32_t number, std::uint32_t base) {
  double sum = 0;
  double digit = 1.0 / base;
  for (; number != 0; number /= base) {
    sum += digit * (number % base);
    digit /= base;
  }
  return sum;
}

/// The n-th prime from 2 on.
std::uint32_t prime(std::size_t n) {
  std::uint32_t candidate = 2;
  for (;; ++candidate) {
    bool is_prime = true;
    for (std::uint32_t i = 2; i * i <= candidate; ++i) {
      is_prime = is_prime && candidate % i != 0;
    }
    if (is_prime && n-- == 0) {
      return candidate;
    }
  }
}

/// Moves one variable by a step up or down if that brings the links nearer. False if none does.
bool step_down(const PairSpace& space, double scale, Place& place) {
  bool moved = false;
  for (std::size_t i = 0; i < place.point.size(); ++i) {
    const Interval& range = space.dimensions()[i].range;
    for (const double direction : {scale, -scale}) {
      Place next = place;
      double& value = next.point[i];
      value = std::clamp(value + direction * (range.upper - range.lower), range.lower, range.upper);
      if (value == place.point[i]) {
        continue;
      }
      next.distance = space.distance(next.point, next.hint);
      if (next.distance < place.distance) {
        place = next;
        moved = true;
        break;
      }
    }
  }
  return moved;
}

/// To where it is 0, or no step of the smallest size leads down.
void go_down(const PairSpace& space, Place& place) {
  int halvings = 0;
  for (int step = 0; step < kMostSteps && halvings < kHalvings && place.distance > 0; ++step) {
    if (!step_down(space, std::ldexp(0.25, -halvings), place)) {
      ++halvings;
    }
  }
}

/// How far a variable can go from `point`, up or down, until they don't intersect any more.
double last_intersecting(const PairSpace& space, const std::vector<double>& point, std::size_t i,
                         double direction) {
  const Interval& range = space.dimensions()[i].range;
  std::vector<double> next = point;
  double last = point[i];
  double step = kFirstStep;
  while (step < 1) {
    const double to = point[i] + direction * step * (range.upper - range.lower);
    next[i] = std::clamp(to, range.lower, range.upper);
    if (next[i] == last || !space.intersect(next)) {
      break;
    }
    last = next[i];
    step *= 2;
  }
  return last;
}

}  // namespace

std::vector<double> deepened(const PairSpace& space, std::vector<double> point) {
  for (std::size_t i = 0; i < point.size(); ++i) {
    std::vector<double> next = point;
    const double low = last_intersecting(space, point, i, -1);
    next[i] = low + (last_intersecting(space, point, i, 1) - low) / 2;
    if (space.intersect(next)) {
      point = next;
    }
  }
  return point;
}

std::vector<double> spread_point(const PairSpace& space, std::uint32_t number) {
  std::vector<double> point;
  for (std::size_t i = 0; i < space.dimensions().size(); ++i) {
    const auto [lower, upper] = space.dimensions()[i].range;
    point.push_back(lower + mirrored(number + 1, prime(i)) * (upper - lower));
  }
  return point;
}

std::optional<std::vector<double>> find_intersection(const PairSpace& space, std::uint32_t starts) {
  std::vector<Place> places;
  for (std::uint32_t i = 0; i < starts; ++i) {
    Place place = {0, spread_point(space, i), {}};
    place.distance = space.distance(place.point, place.hint);
    if (place.distance == 0 && space.intersect(place.point)) {
      return place.point;
    }
    places.push_back(std::move(place));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.distance < b.distance; });
  places.resize(std::min(places.size(), kDescents));
  for (Place& place : places) {
    go_down(space, place);
    if (place.distance == 0 && space.intersect(place.point)) {
      return place.point;
    }
  }
  return std::nullopt;
}

}  // namespace flashbvh::tool
