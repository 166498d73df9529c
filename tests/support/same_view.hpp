// Whether two views contain equal numbers.
#pragma once

#include <stdint.h>
#include <string.h>

#include "flashbvh/robot/robot.hpp"

namespace flashbvh::test {

template <class Element>
bool same_array(const Element* u, const Element* v, uint32_t count) {
  return count == 0 || memcmp(u, v, count * sizeof *u) == 0;
}

template <class Index, Layout layout>
bool same_view(const BasicMesh<Index, layout>& u, const BasicMesh<Index, layout>& v) {
  return u.node_count == v.node_count && u.leaf_count == v.leaf_count &&
         u.stack_need == v.stack_need && u.triangle_count == v.triangle_count &&
         u.vertex_count == v.vertex_count && u.shell_count == v.shell_count &&
         u.longest_edge == v.longest_edge && u.unit == v.unit && u.is_closed == v.is_closed &&
         u.deviation_sixteenths == v.deviation_sixteenths && u.cell_bits == v.cell_bits &&
         same_array(u.origin, v.origin, 3) && same_array(u.nodes, v.nodes, u.node_count) &&
         same_array(u.triangles, v.triangles, u.triangle_count) &&
         same_array(u.triangle_ids, v.triangle_ids, u.triangle_count) &&
         same_array(u.vertices, v.vertices, u.vertex_count) &&
         same_array(u.shell_vertices, v.shell_vertices, u.shell_count) &&
         (u.slabs == nullptr) == (v.slabs == nullptr) &&
         (u.slabs == nullptr || same_array(u.slabs, v.slabs, u.leaf_count)) &&
         (u.leaf_offsets == nullptr) == (v.leaf_offsets == nullptr) &&
         (u.leaf_offsets == nullptr ||
          same_array(u.leaf_offsets, v.leaf_offsets, u.leaf_count + 1u));
}

inline bool same_view(const Robot& u, const Robot& v) {
  bool same = u.joint_count == v.joint_count && u.link_count == v.link_count &&
              u.variable_count == v.variable_count && u.pair_count == v.pair_count &&
              u.reach_count == v.reach_count && u.slack == v.slack &&
              u.distance_table_bytes == v.distance_table_bytes && u.hash == v.hash &&
              u.cell_bits == v.cell_bits && same_array(u.joints, v.joints, u.joint_count) &&
              same_array(u.links, v.links, u.link_count) &&
              same_array(u.pairs, v.pairs, u.pair_count) &&
              same_array(u.reaches, v.reaches, u.reach_count) &&
              same_array(u.distance_tables, v.distance_tables, u.distance_table_bytes);
  for (uint32_t i = 0; same && i < u.link_count; ++i) {
    same = same_view(u.meshes[i], v.meshes[i]);
  }
  return same;
}

}  // namespace flashbvh::test
