// All headers that firmware needs to query baked meshes.
#ifndef FLASHBVH_FLASHBVH_HPP
#define FLASHBVH_FLASHBVH_HPP

#include "flashbvh/clearance.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/deformable.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/self.hpp"
#include "flashbvh/shape.hpp"
#include "flashbvh/solid.hpp"
#include "flashbvh/status.hpp"
#include "flashbvh/time_bound.hpp"
#include "flashbvh/triangle.hpp"
#include "flashbvh/version.hpp"

#endif
