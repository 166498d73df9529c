#include "evaluate/setups.hpp"

namespace flashbvh::scene {
namespace {

constexpr PaperObject upright(std::uint32_t subdivisions) {
  return {subdivisions, kFullRadius, Orientation::upright};
}

constexpr PaperObject kUpright = upright(0);
constexpr PaperObject kLying = {0, kFullRadius, Orientation::lying};
constexpr PaperObject kUpsideDown = {0, kFullRadius, Orientation::upside_down};
constexpr PaperObject kTenth = {0, kFullRadius / 10, Orientation::upright};

/// Two upright tumblers side by side, wall through wall: tables 6 and 8.
constexpr Point kIntersecting = {-2900, 13600, 800};
/// The small tumbler in the thick bottom of the large one, clear of all of its triangles' boxes.
constexpr Point kInTheWall = {-1300, 1500, 7900};

}  // namespace

const std::array<Setup, 20> kSetups = {{
    {2, "Intersection test 1", kUpright, kUpright, {14700, -1200, -200}, 1000},
    {2, "Intersection test 2", kUpright, kUpsideDown, {5500, -7200, -5900}, 1000},
    {2, "Intersection test 3", kUpright, kLying, {11900, 1100, -2800}, 1000},

    {3, "Separation test 1", kUpright, kUpright, {26000, 4000, 1000}, 100000},
    {3, "Separation test 2", kUpright, kUpsideDown, {-3000, 27000, -5000}, 100000},
    {3, "Separation test 3", kUpright, kLying, {6000, -2000, 24000}, 100000},

    // One tumbler stacked into the other, half way and all the way; one next to the other.
    {4, "Close proximity test 1", kUpright, kUpright, {400, -300, 11000}, 1000},
    {4, "Close proximity test 2", kUpright, kUpright, {0, 0, 9000}, 1000},
    {4, "Close proximity test 3", kUpright, kUpsideDown, {-900, 16300, -3600}, 10000},

    {5, "Small proximity test 1", kUpright, kUpright, {24700, -2000, -300}, 10000},
    {5, "Small proximity test 2", kUpright, kLying, {-16500, -11000, -1800}, 10000},
    {5, "Small proximity test 3", kUpright, kUpsideDown, {22200, 500, 5200}, 10000},

    {6, "Sub 0: 796 faces", upright(0), upright(0), kIntersecting, 1000},
    {6, "Sub 1: 3184 faces", upright(1), upright(1), kIntersecting, 1000},
    {6, "Sub 2: 12736 faces", upright(2), upright(2), kIntersecting, 1000},
    {6, "Sub 3: 50944 faces", upright(3), upright(3), kIntersecting, 1000},
    {6, "Sub 4: 203776 faces", upright(4), upright(4), kIntersecting, 1000},

    {7, "Different sizes", kTenth, kUpright, kInTheWall, 1000},

    {8, "Different levelled objects, largest first", upright(4), kUpright, kIntersecting, 1000},
    {8, "Different levelled objects, smallest first", kUpright, upright(4), kIntersecting, 1000},
}};

const char* table_title(std::uint32_t table) {
  constexpr const char* kTitles[] = {"Intersection",
                                     "Separation",
                                     "Close proximity",
                                     "Small proximity",
                                     "Scalability",
                                     "Objects of different sizes",
                                     "Objects with different number of primitives"};
  return kTitles[table - kFirstTable];
}

}  // namespace flashbvh::scene
