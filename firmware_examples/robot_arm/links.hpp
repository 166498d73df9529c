// The arm's links: trees compiled in, and images as bytes in flash.
#ifndef ROBOT_ARM_LINKS_HPP
#define ROBOT_ARM_LINKS_HPP

#include <stddef.h>
#include <stdint.h>

#include "base_link.fbvh.hpp"
#include "bicep.fbvh.hpp"
#include "elbow.fbvh.hpp"
#include "forearm.fbvh.hpp"
#include "palm.fbvh.hpp"
#include "shoulder.fbvh.hpp"
#include "wrist.fbvh.hpp"

struct Link {
  const char* name;
  const flashbvh::MeshWithLevels* post;
  const unsigned char* image;  ///< pre-indexed
  const unsigned char* image_end;

  size_t image_bytes() const { return static_cast<size_t>(image_end - image); }
};

// images.S
#define IMAGE(name)                              \
  extern "C" const unsigned char name##_image[]; \
  extern "C" const unsigned char name##_image_end[];
IMAGE(base_link)
IMAGE(shoulder)
IMAGE(bicep)
IMAGE(elbow)
IMAGE(forearm)
IMAGE(wrist)
IMAGE(palm)
#undef IMAGE

namespace robot {

#define LINK(name) \
  constexpr Link name = {#name, &::name::levelled_mesh, name##_image, name##_image_end};
LINK(base_link)
LINK(shoulder)
LINK(bicep)
LINK(elbow)
LINK(forearm)
LINK(wrist)
LINK(palm)
#undef LINK

/// From the base to the palm, as the joints connect them.
constexpr Link kLinks[] = {base_link, shoulder, bicep, elbow, forearm, wrist, palm};

constexpr uint32_t larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

/// Of the link that needs most.
constexpr uint32_t kStackNeed =
    larger(larger(larger(::base_link::kStackNeed, ::shoulder::kStackNeed),
                  larger(::bicep::kStackNeed, ::elbow::kStackNeed)),
           larger(larger(::forearm::kStackNeed, ::wrist::kStackNeed), ::palm::kStackNeed));

}  // namespace robot

#endif
