// The moving bodies and the obstacles, in millimetres from a corner of the bed.
#pragma once

#include <flashbvh/image.hpp>

#include "arch.fbvh.h"
#include "clamp.fbvh.h"
#include "gantry.fbvh.h"
#include "head.fbvh.h"
#include "vase.fbvh.h"
#include "wheel.fbvh.h"

using flashbvh::Mesh;
using flashbvh::view_unchecked;

const Mesh head = view_unchecked<Mesh>(head_image);
const Mesh gantry = view_unchecked<Mesh>(gantry_image);
const Mesh clamp = view_unchecked<Mesh>(clamp_image);
const Mesh vase = view_unchecked<Mesh>(vase_image);
const Mesh wheel = view_unchecked<Mesh>(wheel_image);
const Mesh arch = view_unchecked<Mesh>(arch_image);

/// The origin of both meshes is the nozzle's tip, but the gantry does not move along x.
struct Body {
  const char* name;
  const Mesh& mesh;
  bool goes_along_x;
};
const Body kBodies[] = {{"head", head, true}, {"gantry", gantry, false}};
/// The x coordinate of the gantry's centre.
constexpr int kMiddle = 110;

/// A fixture or a finished part. The part being printed is not an obstacle: the nozzle touches it.
struct Obstacle {
  const char* name;
  const Mesh& mesh;
  int x;
  int y;
};
const Obstacle kObstacles[] = {
    {"left clamp", clamp, 15, 110},  {"right clamp", clamp, 205, 110},
    {"front clamp", clamp, 110, 15}, {"back clamp", clamp, 110, 205},
    {"vase", vase, 60, 150},         {"wheel", wheel, 165, 165},
    {"arch", arch, 45, 60},
};

constexpr int kBodyCount = sizeof kBodies / sizeof *kBodies;
constexpr int kObstacleCount = sizeof kObstacles / sizeof *kObstacles;
static_assert(head_TRIANGLE_COUNT + gantry_TRIANGLE_COUNT + clamp_TRIANGLE_COUNT +
                      vase_TRIANGLE_COUNT + wheel_TRIANGLE_COUNT + arch_TRIANGLE_COUNT >=
                  20000,
              "the figure in the documents");
