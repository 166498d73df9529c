#include "image.hpp"

#include <cstring>

namespace robot_check {
namespace {

[[noreturn]] void refuse(std::size_t offset, const std::string& what) {
  throw BadImage("byte " + std::to_string(offset) + ": " + what);
}

/// Reads consecutive little-endian numbers.
class Reader {
 public:
  Reader(const std::string& bytes, std::size_t begin, std::size_t end)
      : bytes_(bytes), begin_(begin), at_(begin), end_(end) {}

  template <class Number>
  Number read() {
    need(sizeof(Number));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      value |= std::uint64_t{static_cast<std::uint8_t>(bytes_[at_++])} << (8 * i);
    }
    return static_cast<Number>(value);
  }
  std::uint8_t u8() { return read<std::uint8_t>(); }
  std::uint16_t u16() { return read<std::uint16_t>(); }
  std::uint32_t u32() { return read<std::uint32_t>(); }
  std::int32_t i32() { return read<std::int32_t>(); }
  double f32() {
    const auto bits = read<std::uint32_t>();
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return static_cast<double>(value);
  }
  template <std::size_t N>
  void i32s(std::int32_t (&values)[N]) {
    for (std::int32_t& value : values) {
      value = i32();
    }
  }
  std::string text() {
    const std::size_t end = bytes_.find('\0', at_);
    if (end >= end_ || end - at_ > 255) {
      refuse(at_, "a name without an end, or longer than 255 bytes");
    }
    std::string name = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return name;
  }
  void need(std::size_t count) const {
    if (count > end_ - at_) {
      refuse(at_, "the image ends within what its header counts");
    }
  }
  void zero(std::uint32_t value) const {
    if (value != 0) {
      refuse(at_, "not zero where the format wants zeros");
    }
  }
  /// Moves to the next word.
  void fill() {
    while ((at_ - begin_) % 4 != 0) {
      zero(u8());
    }
  }
  std::size_t at() const { return at_; }

 private:
  const std::string& bytes_;
  std::size_t begin_;
  std::size_t at_;
  std::size_t end_;
};

/// The CRC of IEEE 802.3, bit by bit; skips the four bytes at 12.
std::uint32_t checksum(const std::string& bytes, std::size_t begin, std::size_t end) {
  std::uint32_t crc = ~0u;
  for (std::size_t i = begin; i < end; ++i) {
    if (i - begin >= 12 && i - begin < 16) {
      continue;
    }
    crc ^= static_cast<std::uint8_t>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) {
      crc = crc >> 1 ^ (0xEDB88320u & (0u - (crc & 1)));
    }
  }
  return ~crc;
}

/// Adds bytes to a hash, FNV-1a.
void hash(const std::string& bytes, std::size_t begin, std::size_t end, std::uint32_t& value) {
  for (std::size_t i = begin; i < end; ++i) {
    value = (value ^ static_cast<std::uint8_t>(bytes[i])) * 16777619u;
  }
}

/// Orthonormalises the rotation's columns; the change, a rounding error, is within the slack.
Frame frame_of(const std::int32_t (&rotation)[3][3], const std::int32_t (&translation)[3]) {
  Frame frame;
  for (std::size_t i = 0; i < 3; ++i) {
    frame.axes[i] = 0x1p-30 * Vec{1.0 * rotation[0][i], 1.0 * rotation[1][i], 1.0 * rotation[2][i]};
  }
  Vec& x = frame.axes[0];
  Vec& y = frame.axes[1];
  x = 1 / length(x) * x;
  y = y - dot(x, y) * x;
  y = 1 / length(y) * y;
  frame.axes[2] = cross(x, y);
  frame.origin = 1.0 / 2048 * vec_of(translation);
  return frame;
}

Joint read_joint(Reader& in) {
  Joint joint{};
  for (auto& row : joint.rotation) {
    in.i32s(row);
  }
  in.i32s(joint.translation);
  joint.lower = in.i32();
  joint.upper = in.i32();
  joint.multiplier = in.i32();
  joint.offset = in.i32();
  joint.shift = in.u8();
  joint.parent = in.u8();
  joint.variable = in.u8();
  joint.type = in.u8();
  joint.zeros = in.u32();
  joint.fixed = frame_of(joint.rotation, joint.translation);
  return joint;
}

Link read_link(Reader& in) {
  Link link{};
  in.i32s(link.centre);
  link.radius = in.u32();
  link.first_reach = in.u16();
  link.joint = in.u8();
  link.zero = in.u8();
  link.deviation = in.u32();
  return link;
}

Pair read_pair(Reader& in) {
  Pair pair{};
  pair.stop = in.u32();
  pair.warn = in.u32();
  pair.reach = in.u32();
  pair.a = in.u8();
  pair.b = in.u8();
  pair.joints_a = in.u8();
  pair.joints_b = in.u8();
  return pair;
}

Unguarded read_unguarded(Reader& in) {
  Unguarded pair{};
  pair.a = in.u8();
  pair.b = in.u8();
  pair.why = in.u8();
  pair.joint = in.u8();
  pair.radius = in.u32();
  return pair;
}

/// `element`: reads one element. Arrays begin at multiples of 4.
template <class Element, class Read>
void read_array(Reader& in, std::vector<Element>& elements, std::size_t count, Read&& element) {
  in.fill();
  in.need(count);
  for (std::size_t i = 0; i < count; ++i) {
    elements.push_back(element());
  }
}

struct MeshCounts {
  std::size_t end;  ///< of the image, in bytes
  std::uint32_t triangles, vertices, shells, name_size;
};

MeshCounts read_mesh_header(const std::string& bytes, Reader& in, Mesh& mesh) {
  const std::size_t begin = in.at();
  if (in.u32() != 0x48564246) {
    refuse(begin, "no mesh begins here: its magic is not FBVH");
  }
  const std::uint32_t version = in.u16();
  const std::uint32_t layout = in.u8();
  const std::uint32_t index_bits = in.u8();
  if (version != 3 || layout != 1 || index_bits != 16) {
    refuse(begin, "a mesh of another version, layout or index width than 3, post-indexed, 16 bits");
  }
  MeshCounts counts{};
  counts.end = begin + in.u32();
  if (counts.end > bytes.size() || counts.end < begin + 80 ||
      checksum(bytes, begin, counts.end) != in.u32()) {
    refuse(begin, "the mesh is cut off or its checksum does not match");
  }
  mesh.node_count = in.u32();
  mesh.leaf_count = in.u32();
  counts.triangles = in.u32();
  counts.vertices = in.u32();
  in.u32();  // depth, then stack_need: not used by this program
  in.u32();
  in.u8();  // leaf_size
  counts.name_size = in.u8();
  in.u16();
  in.i32s(mesh.origin);
  mesh.cell_bits = in.read<std::uint64_t>();
  mesh.deviation = in.f32();
  in.u32();  // the deviation in cells
  counts.shells = in.u32();
  in.u16();
  mesh.unit = in.u8();
  mesh.flags = in.u8();
  return counts;
}

/// Adds the arrays that belong to the robot's hash to it.
void read_mesh_arrays(const std::string& bytes, Reader& in, const MeshCounts& counts, Mesh& mesh,
                      std::uint32_t& robot_hash) {
  const auto index = [&] { return std::uint32_t{in.u16()}; };
  std::vector<std::uint32_t> unused;
  read_array(in, mesh.nodes, std::size_t{mesh.node_count} * 16, [&] { return in.u8(); });
  hash(bytes, in.at() - mesh.nodes.size(), in.at(), robot_hash);
  if ((mesh.flags & 1) != 0) {
    read_array(in, unused, mesh.node_count, index);
    read_array(in, unused, mesh.node_count, index);
  }
  const auto corners = [&] { return std::array<std::uint16_t, 3>{in.u16(), in.u16(), in.u16()}; };
  read_array(in, mesh.corners, counts.triangles, corners);
  hash(bytes, in.at() - 6 * mesh.corners.size(), in.at(), robot_hash);
  read_array(in, unused, counts.triangles, index);
  if (mesh.leaf_count != counts.triangles) {
    read_array(in, mesh.leaf_offsets, mesh.leaf_count + std::size_t{1}, index);
  } else {
    for (std::uint32_t i = 0; i <= mesh.leaf_count; ++i) {
      mesh.leaf_offsets.push_back(i);
    }
  }
  read_array(in, mesh.lattice, counts.vertices, [&] {
    return std::array<std::int32_t, 3>{in.read<std::int16_t>(), in.read<std::int16_t>(),
                                       in.read<std::int16_t>()};
  });
  hash(bytes, in.at() - 6 * mesh.lattice.size(), in.at(), robot_hash);
  read_array(in, unused, counts.shells, index);
  in.fill();
  in.need(counts.name_size);
}

/// Adds the mesh's part of the robot's hash; `at`: the mesh's offset, then the offset after it.
Mesh read_mesh(const std::string& bytes, std::size_t& at, std::uint32_t& robot_hash) {
  const std::size_t begin = at;
  Reader in(bytes, begin, bytes.size());
  Mesh mesh{};
  const MeshCounts counts = read_mesh_header(bytes, in, mesh);
  read_mesh_arrays(bytes, in, counts, mesh, robot_hash);
  hash(bytes, begin + 44, begin + 56, robot_hash);  // origin
  for (const auto& [x, y, z] : mesh.lattice) {
    mesh.vertices.push_back(
        {1.0 * x + mesh.origin[0], 1.0 * y + mesh.origin[1], 1.0 * z + mesh.origin[2]});
  }
  for (const auto& corner : mesh.corners) {
    for (const std::uint16_t number : corner) {
      if (number >= counts.vertices) {
        refuse(begin, "a triangle of the mesh has a corner that is no vertex");
      }
    }
  }
  at = counts.end;
  return mesh;
}

struct Counts {
  std::uint32_t joints, links, crc, hash, table_bytes, pairs, reaches, names_size, mounts,
      unguarded;
};

Counts read_header(const std::string& bytes, Reader& in, Robot& robot) {
  if (in.u32() != 0x52564246) {
    refuse(0, "no robot: its magic is not FBVR; give the .robot file that flashbvh robot writes");
  }
  const std::uint32_t version = in.u16();
  if (version != 5) {
    refuse(4, "a robot of version " + std::to_string(version) + ", not 5: bake it again");
  }
  Counts counts{};
  counts.joints = in.u8();
  counts.links = in.u8();
  if (in.u32() != bytes.size()) {
    refuse(8, "the file's size is not byte_count");
  }
  counts.crc = in.u32();
  counts.hash = in.u32();
  robot.slack = in.u32();
  robot.cell_bits = in.read<std::uint64_t>();
  std::memcpy(&robot.cell, &robot.cell_bits, sizeof robot.cell);
  robot.pair_joint_count = in.u32();
  counts.table_bytes = in.u32();
  counts.pairs = in.u16();
  counts.reaches = in.u16();
  counts.names_size = in.u16();
  robot.variable_count = in.u8();
  counts.mounts = in.u8();
  counts.unguarded = in.u16();
  in.zero(in.u16());
  return counts;
}

void read_names(Reader& in, const Counts& counts, Robot& robot) {
  const std::size_t begin = in.at();
  robot.name = in.text();
  for (Joint& joint : robot.joints) {
    joint.name = in.text();
  }
  for (Link& link : robot.links) {
    link.name = in.text();
  }
  for (std::uint32_t i = 0; i < counts.mounts; ++i) {
    in.text();
  }
  if (in.at() - begin != counts.names_size) {
    refuse(begin, "the names are not names_size bytes");
  }
  in.fill();
}

/// Returns the hash of all arrays before the meshes.
std::uint32_t read_arrays(const std::string& bytes, Reader& in, const Counts& counts,
                          Robot& robot) {
  std::uint32_t value = 2166136261u;
  const std::size_t begin = in.at();
  read_array(in, robot.joints, counts.joints, [&] { return read_joint(in); });
  read_array(in, robot.links, counts.links, [&] { return read_link(in); });
  read_array(in, robot.pairs, counts.pairs, [&] { return read_pair(in); });
  read_array(in, robot.reaches, counts.reaches, [&] { return in.u32(); });
  hash(bytes, begin, in.at(), value);
  std::vector<std::uint8_t> mounts;
  read_array(in, mounts, counts.mounts * std::size_t{52}, [&] { return in.u8(); });
  read_array(in, robot.unguarded, counts.unguarded, [&] { return read_unguarded(in); });
  read_array(in, robot.tables, counts.table_bytes, [&] { return in.u8(); });
  hash(bytes, in.at() - counts.table_bytes, in.at(), value);
  hash(bytes, 20, 32, value);  // slack and cell
  return value;
}

}  // namespace

Robot read_robot(const std::string& bytes) {
  Reader in(bytes, 0, bytes.size());
  Robot robot{};
  const Counts counts = read_header(bytes, in, robot);
  std::uint32_t value = read_arrays(bytes, in, counts, robot);
  read_names(in, counts, robot);
  std::size_t at = in.at();
  if (checksum(bytes, 0, at) != counts.crc) {
    refuse(12, "the robot's checksum does not match");
  }
  for (Link& link : robot.links) {
    link.mesh = read_mesh(bytes, at, value);
  }
  if (at != bytes.size() || value != counts.hash) {
    refuse(16, "bytes are left behind the last mesh, or the hash does not match");
  }
  return robot;
}

}  // namespace robot_check
