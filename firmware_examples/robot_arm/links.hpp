// The arm's links: images that the build compiled, and images as bytes in flash.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base_link.fbvh.h"
#include "bicep.fbvh.h"
#include "elbow.fbvh.h"
#include "forearm.fbvh.h"
#include "palm.fbvh.h"
#include "shoulder.fbvh.h"
#include "wrist.fbvh.h"

struct Link {
  const char* name;
  const uint32_t* post;      ///< post-indexed, with levels
  const unsigned char* pre;  ///< pre-indexed
  const unsigned char* pre_end;

  size_t pre_bytes() const { return static_cast<size_t>(pre_end - pre); }
};

// images.S
#define IMAGE(name)                            \
  extern "C" const unsigned char name##_pre[]; \
  extern "C" const unsigned char name##_pre_end[];
IMAGE(base_link)
IMAGE(shoulder)
IMAGE(bicep)
IMAGE(elbow)
IMAGE(forearm)
IMAGE(wrist)
IMAGE(palm)
#undef IMAGE

namespace robot {

#define LINK(name) constexpr Link name = {#name, name##_image, name##_pre, name##_pre_end};
LINK(base_link)
LINK(shoulder)
LINK(bicep)
LINK(elbow)
LINK(forearm)
LINK(wrist)
LINK(palm)
#undef LINK

/// From the base to the palm, in the order of the joints.
constexpr Link kLinks[] = {base_link, shoulder, bicep, elbow, forearm, wrist, palm};

constexpr uint32_t larger(uint32_t a, uint32_t b) {
  return a > b ? a : b;
}

/// The stack need of the link that needs most.
constexpr uint32_t kStackNeed =
    larger(larger(larger(base_link_STACK_NEED, shoulder_STACK_NEED),
                  larger(bicep_STACK_NEED, elbow_STACK_NEED)),
           larger(larger(forearm_STACK_NEED, wrist_STACK_NEED), palm_STACK_NEED));

}  // namespace robot
