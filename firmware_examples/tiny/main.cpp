// How much RAM do queries of a moving ball and a capsule need, on a BBC micro:bit?
//
// The mesh of 2,048 triangles stays in flash, as baked. The moving body is a point or a segment,
// made for each query; its radius is the query's distance.
#include <stdint.h>

#include <flashbvh/flashbvh.hpp>
#include <flashbvh/image.hpp>
#include <flashbvh/shape.hpp>

#include "ring.fbvh.h"
#include "stack.hpp"
#include "start.hpp"
#include "text.hpp"

using namespace flashbvh;

static_assert(ring_TRIANGLE_COUNT > 1000 && ring_IMAGE_BYTES < 64 * 1024);

namespace {

const Mesh ring = view_unchecked<Mesh>(ring_image);

constexpr uint32_t kMostRam = 1024;

/// Shapes are made at their position in the ring's frame, so the pose is constant, in flash.
constexpr Pose kHere = Pose::translated(0, 0, 0);

/// Converts a radius in cells to a distance in 1/256 cell. The ball includes its surface.
constexpr FineLength radius(uint32_t cells) {
  return {cells * 256};
}

bool ball_touches(const Point& middle) {
  const PointShape ball(ring, middle);
  return closer_than(ring, ball.mesh(), kHere, radius(1500)).yes;
}

/// A tool of 40 mm, upright. Not inlined, so that its end points leave the stack before the query.
[[gnu::noinline]] SegmentShape upright(const Point& tip) {
  return SegmentShape(ring, tip, {tip.x, tip.y, tip.z + 4000});
}

bool capsule_touches(const Point& tip) {
  const SegmentShape axis = upright(tip);
  return closer_than(ring, axis.mesh(), kHere, radius(800)).yes;
}

struct Moved {
  uint32_t touching;
  uint32_t stack;  ///< the most bytes that a query took, including the shape
};

/// Moves along a line over the ring, down into its hole and through its wall.
template <class Touches>
Moved move(const Touches& touches) {
  Moved moved = {0, 0};
  for (int32_t i = 0; i < 64; ++i) {
    const Point at = {-16000 + 500 * i, 250 * i - 8000, 5000 - 150 * i};
    bool yes = false;
    const uint32_t stack = port::stack_of([&] { yes = touches(at); });
    moved.stack = stack > moved.stack ? stack : moved.stack;
    moved.touching += yes ? 1 : 0;
  }
  return moved;
}

uint32_t static_ram() {
  return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(__bss_end) -
                               reinterpret_cast<uintptr_t>(__data_start));
}

/// Prints the bytes of RAM; true if they are below the limit.
bool print(const char* name, const Moved& moved) {
  const uint32_t ram = static_ram() + moved.stack;
  port::print(name, moved.touching, " of 64 places touch; ", moved.stack, " bytes of stack and ",
              static_ram(), " static: ", ram, " bytes of RAM\n");
  return ram < kMostRam;
}

}  // namespace

int main() {
  port::print("ring: ", ring_TRIANGLE_COUNT, " triangles, ", ring_IMAGE_BYTES, " bytes of flash\n");
  const bool ball = print("ball: ", move(ball_touches));
  const bool capsule = print("capsule: ", move(capsule_touches));
  return ball && capsule ? 0 : 1;
}
