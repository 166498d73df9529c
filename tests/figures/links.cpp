// Poses of pairs of links, found once for trees of one triangle a leaf: from any direction B came
// until it touched A, and moved on or back by a part of its size.
#include "links.hpp"

#include "bicep.fbvh.h"
#include "flashbvh/detail/predicates/fraction.hpp"
#include "flashbvh/image.hpp"
#include "forearm.fbvh.h"
#include "palm.fbvh.h"
#include "support/points.hpp"
#include "support/rotations.hpp"
#include "wrist.fbvh.h"

using namespace flashbvh;

namespace figures {
namespace {

const Mesh bicep = view_unchecked<Mesh>(bicep_image);
const Mesh forearm = view_unchecked<Mesh>(forearm_image);
const Mesh palm = view_unchecked<Mesh>(palm_image);
const Mesh wrist = view_unchecked<Mesh>(wrist_image);

constexpr uint64_t kSeed = 20240607;
constexpr int32_t kRadius = 20000;

/// By motion, pair, class and number: the random numbers drawn before B's rotation and direction,
/// and the distance in cells between the middles of both boxes.
constexpr uint16_t kFound[2][2 * kLinkPairs * kProximities * kPosesOfPair] = {
    {0,   24775, 7,   15521, 19,  21269, 29,  20358, 36,  22777, 46,  16437, 56,  26505,
     63,  19007, 67,  24459, 75,  15021, 85,  24709, 92,  27233, 99,  18590, 100, 23052,
     113, 9781,  117, 30377, 315, 13254, 318, 7070,  336, 9197,  342, 6715,  351, 12340,
     360, 5982,  366, 7514,  378, 8157,  387, 14791, 399, 5628,  423, 6810,  426, 8662,
     429, 8283,  432, 7347,  435, 6747,  444, 5054,  453, 14886, 445, 8288,  470, 13502,
     480, 6233,  481, 9659,  491, 16188, 495, 11790, 496, 16368, 512, 5589,  516, 4892,
     526, 9415,  530, 6896,  546, 3442,  568, 6484,  584, 3690,  588, 9162,  0,   24449,
     7,   14963, 17,  12685, 18,  12383, 19,  19122, 29,  18622, 36,  10757, 46,  11744,
     56,  25280, 63,  15197, 67,  23322, 75,  11865, 85,  24085, 92,  25898, 99,  19198,
     100, 20065, 400, 6932,  403, 9000,  415, 8211,  424, 7738,  430, 8494,  433, 11328,
     436, 10590, 442, 10375, 445, 7755,  469, 6697,  481, 7669,  496, 6574,  511, 7444,
     517, 8448,  523, 11417, 529, 6317,  544, 9559,  545, 4652,  546, 6602,  568, 8644,
     584, 8993,  588, 3341,  592, 4672,  602, 9004,  606, 6124,  610, 6396,  614, 9991,
     615, 9268,  625, 6268,  638, 4913,  645, 9237,  646, 4771,  0,   39136, 7,   26387,
     19,  30341, 29,  31360, 36,  28257, 46,  23763, 56,  41573, 63,  27140, 67,  37766,
     75,  20868, 85,  38720, 92,  44445, 99,  30158, 100, 32894, 113, 18430, 117, 42215,
     616, 18457, 640, 21151, 661, 21174, 664, 21464, 673, 10777, 688, 10321, 697, 9720,
     703, 18394, 721, 20089, 748, 18148, 763, 16071, 772, 10163, 775, 13561, 778, 21082,
     799, 11715, 802, 12481, 808, 10760, 818, 8476,  831, 20008, 832, 2632,  842, 5573,
     846, 15741, 850, 5830,  860, 5387,  867, 14124, 871, 9971,  875, 11431, 891, 20117,
     901, 18599, 905, 8918,  912, 4176,  916, 18968, 0,   28380, 7,   17968, 18,  9197,
     19,  22456, 29,  22098, 36,  22509, 46,  16648, 56,  29975, 63,  19503, 67,  26426,
     75,  15247, 85,  29643, 92,  30903, 99,  21508, 100, 24127, 113, 11886, 315, 16368,
     318, 6985,  336, 9660,  342, 8751,  351, 15805, 360, 8398,  366, 11751, 378, 10407,
     387, 17185, 399, 7143,  423, 6720,  426, 12292, 429, 10559, 435, 6658,  453, 18425,
     459, 11629, 468, 6464,  475, 15534, 482, 3570,  489, 8353,  496, 16725, 512, 5628,
     516, 6845,  526, 11971, 530, 6430,  546, 2611,  568, 7998,  584, 5073,  588, 11987,
     592, 15153, 602, 10962, 606, 12697},
    {588,  20128, 618,  23613, 630,  27751, 659,  15166, 702,  27801, 741,  21939, 780,  27688,
     801,  22323, 833,  19105, 868,  25662, 872,  21362, 943,  17119, 959,  19276, 979,  28629,
     982,  16396, 1011, 23525, 1393, 12020, 1414, 4910,  1417, 8260,  1452, 6029,  1497, 13663,
     1530, 7119,  1548, 10808, 1574, 9286,  1593, 8619,  1628, 6262,  1679, 4933,  1743, 9067,
     1745, 9923,  1759, 17636, 1774, 13129, 1789, 7092,  1796, 6505,  1813, 9510,  1833, 6614,
     1834, 10141, 1862, 5323,  1898, 7684,  1905, 11849, 1925, 14844, 1954, 15534, 1962, 5500,
     1961, 4410,  1985, 3870,  2024, 5226,  2044, 5070,  2056, 7445,  2069, 15892, 659,  14818,
     702,  25267, 741,  9537,  780,  22895, 801,  16137, 833,  17742, 845,  9853,  868,  24833,
     872,  12373, 943,  11533, 959,  15309, 967,  7236,  979,  21848, 1011, 13107, 1041, 7851,
     1052, 19377, 1423, 6242,  1454, 8511,  1453, 11806, 1483, 6394,  1497, 8631,  1530, 9637,
     1548, 9291,  1574, 4761,  1593, 10901, 1628, 11996, 1679, 8910,  1694, 7791,  1743, 11003,
     1745, 7789,  1759, 6611,  1774, 7475,  1789, 8163,  1797, 5854,  1811, 7489,  1831, 4383,
     1835, 6937,  1834, 6372,  1862, 7076,  1898, 8012,  1905, 6722,  1925, 4989,  1954, 4162,
     1962, 11137, 1961, 6835,  1985, 8034,  2024, 7023,  2044, 9264,  915,  34255, 941,  30345,
     961,  34488, 980,  26152, 1013, 21792, 1032, 37888, 1043, 32239, 1091, 47377, 1125, 33235,
     1133, 22327, 1159, 30531, 1171, 38153, 1186, 33336, 1194, 35506, 1210, 38401, 1230, 40186,
     1927, 9968,  1962, 12669, 1976, 12970, 1987, 10636, 1994, 22679, 2043, 20969, 2053, 16508,
     2056, 13295, 2080, 11470, 2099, 17435, 2108, 11781, 2115, 15436, 2154, 18216, 2169, 12685,
     2170, 10667, 2205, 19311, 2203, 5830,  2242, 11563, 2281, 10555, 2295, 19669, 2293, 6238,
     2333, 11018, 2332, 16127, 2359, 10718, 2379, 3058,  2402, 8883,  2414, 9479,  2429, 10689,
     2433, 14816, 2448, 15787, 2463, 10121, 2485, 6563,  610,  17485, 618,  26048, 630,  29403,
     659,  17245, 702,  30636, 741,  24542, 780,  32014, 801,  24089, 833,  21071, 868,  27696,
     872,  26618, 943,  19536, 959,  20352, 979,  31989, 982,  17852, 1011, 27679, 1594, 9877,
     1625, 6326,  1676, 9185,  1696, 8174,  1733, 10137, 1744, 15051, 1759, 18468, 1774, 16118,
     1789, 7708,  1796, 10907, 1812, 6960,  1831, 6107,  1834, 13749, 1861, 18887, 1896, 7218,
     1905, 15810, 1928, 6992,  1970, 4074,  1982, 12392, 1985, 3535,  2024, 7428,  2044, 5692,
     2056, 7937,  2069, 15855, 2095, 5021,  2098, 9643,  2154, 13396, 2170, 6744,  2206, 4833,
     2241, 10047, 2288, 8165,  2342, 9350}};

/// A uniform point in a ball, but not near its middle: so its direction is uniform, too.
template <uint32_t dimensions>
void set_in_ball(test::Random& random, int32_t (&point)[dimensions]) {
  int32_t square = 0;
  do {
    square = 0;
    for (int32_t& part : point) {
      part = random.between(-kRadius, kRadius);
      square += part * part;
    }
  } while (square > kRadius * kRadius || square < kRadius * kRadius / 16);
}

}  // namespace

const LinkPair kPairs[kLinkPairs] = {{"bicep", "palm", &bicep, &palm},
                                     {"forearm", "palm", &forearm, &palm},
                                     {"bicep", "forearm", &bicep, &forearm},
                                     {"bicep", "wrist", &bicep, &wrist}};

Pose PoseKey::pose(int32_t along_x) const {
  const uint32_t at =
      (pair * kProximities + static_cast<uint32_t>(proximity)) * kPosesOfPair + number;
  const uint16_t* const found = kFound[rotated ? 1 : 0] + 2 * at;
  test::Random random(kSeed);
  for (uint32_t i = 0; i < found[0]; ++i) {
    (void)random.next();
  }
  int32_t q[4] = {1, 0, 0, 0};
  if (rotated) {
    set_in_ball(random, q);
  }
  int32_t direction[3];
  set_in_ball(random, direction);
  const auto square = static_cast<uint64_t>(
      direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
  const int64_t length = detail::square_root(square);
  const MeshBox a(*kPairs[pair].a);
  const MeshBox b(*kPairs[pair].b);
  const test::Rotation rotation = test::rotation_of({q[0], q[1], q[2], q[3]});
  const Pose turned = Pose::rigid(rotation.entry, {0, 0, 0});
  int32_t cells[3];
  for (int axis = 0; axis < 3; ++axis) {
    const auto twice = [](const MeshBox& box, int of) {
      return int64_t{box.lower.*test::kPointAxes[of]} + box.upper.*test::kPointAxes[of];
    };
    int64_t middle = 0;  // of B, rotated, twice
    for (int i = 0; i < 3; ++i) {
      middle += turned.rotation(axis, i) * twice(b, i);
    }
    const int64_t aligned = (twice(a, axis) - middle / kRotationOne) / 2;
    cells[axis] = static_cast<int32_t>(aligned + int64_t{direction[axis]} * found[1] / length);
  }
  cells[0] += along_x;
  return Pose::rigid(rotation.entry, cells);
}

}  // namespace figures
