// The bounds for a whole period from the distances at both ends, against all motions in between.
#include "robot/guard_parts.hpp"
#include "support/test.hpp"

namespace {

/// The least distance at any moment, when the joints have moved `u` and have `way - u` left.
std::int64_t least_between(std::int64_t began, std::int64_t ended, std::int64_t way) {
  std::int64_t least = std::max(began, ended - way);
  for (std::int64_t u = 0; u <= way; ++u) {
    least = std::min(least, std::max(began - u, ended - (way - u)));
  }
  return std::max<std::int64_t>(least, 0);
}

}  // namespace

TEST_CASE("what is kept of a period is the least between its ends") {
  for_rounds(rounds(20000, 200000), [](Random& random, int) {
    const std::uint32_t way = random.below(60);
    const std::uint32_t ended = random.below(200);
    // The distances at the two ends differ by at most the travel.
    const std::int64_t other =
        std::int64_t{ended} + random.between(-static_cast<int>(way), static_cast<int>(way));
    const auto began = static_cast<std::uint32_t>(std::max<std::int64_t>(0, other));
    const std::uint32_t kept = detail::kept_of(ended, began, way);
    const std::int64_t least = least_between(began, ended, way);
    CAPTURE(way, began, ended, kept, least);
    REQUIRE(kept <= least);
    REQUIRE(kept + 1 >= least);
  });
}

TEST_CASE("what lasts a period keeps the pair beyond the limit, and less does not") {
  for_rounds(rounds(20000, 200000), [](Random& random, int) {
    const std::uint32_t way = random.below(60);
    const std::uint32_t limit = random.below(200);
    const std::uint32_t began = random.below(300);
    const std::uint32_t enough = detail::lasting(limit, began, way + detail::kRateMargin);
    CAPTURE(way, limit, began, enough);
    REQUIRE(detail::kept_of(enough, began, way) > limit);
    REQUIRE(detail::kept_of(enough - detail::kRateMargin, began, way) <= limit);
  });
}
