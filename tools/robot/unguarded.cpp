#include "robot/unguarded.hpp"

#include <algorithm>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct Why {
  WhyUnguarded why;
  const char* reason;
  const char* advice;
};

constexpr Why kWhys[] = {
    {WhyUnguarded::intersecting, "neighbours that intersect at all configurations tried",
     "make a part that stands in the other link's way (a post on a table) a link of its own, on a "
     "fixed joint"},
    {WhyUnguarded::believed, "disabled in the SRDF and believed, though they may collide",
     "to guard a pair, delete its line in the SRDF and its --believe"},
};

const Why& of(WhyUnguarded why) {
  return kWhys[static_cast<std::size_t>(why)];
}

}  // namespace

UnguardedPair unguarded_pair(std::size_t a, std::size_t b, WhyUnguarded why) {
  return {a, b, of(why).reason, why};
}

std::vector<UnguardedPair> unguarded_pairs(const std::vector<PairVerdict>& pairs) {
  std::vector<UnguardedPair> unguarded;
  for (const PairVerdict& pair : pairs) {
    if (pair.verdict == MatrixVerdict::always || pair.verdict == MatrixVerdict::believed) {
      unguarded.push_back(unguarded_pair(pair.a, pair.b,
                                         pair.verdict == MatrixVerdict::always
                                             ? WhyUnguarded::intersecting
                                             : WhyUnguarded::believed));
    }
  }
  return unguarded;
}

RobotUnguarded fixed_unguarded(const UnguardedPair& pair) {
  return {static_cast<std::uint8_t>(pair.a), static_cast<std::uint8_t>(pair.b), pair.why, 0};
}

std::string names_of(const Model& model, const std::vector<UnguardedPair>& pairs) {
  std::string names;
  for (const UnguardedPair& pair : pairs) {
    names += concat(names.empty() ? "" : ", ", model.links[pair.a].name, " - ",
                    model.links[pair.b].name);
  }
  return names;
}

std::vector<std::string> unguarded_warnings(const Model& model,
                                            const std::vector<UnguardedPair>& pairs) {
  std::vector<std::string> warnings;
  for (const Why& why : kWhys) {
    std::vector<UnguardedPair> named;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(named),
                 [&](const UnguardedPair& pair) { return pair.why == why.why; });
    if (!named.empty()) {
      warnings.push_back(concat("not guarded: ", names_of(model, named), " (", why.reason,
                                "): a collision of these is never detected; ", why.advice));
    }
  }
  return warnings;
}

}  // namespace flashbvh::tool
