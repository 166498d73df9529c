#include "mesh/guarded_import.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <type_traits>

#include "mesh/guarded_child.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

// The first byte of a result; the mesh or the message follows.
constexpr char kMesh = 'm';
constexpr char kRefusal = 'r';

std::string result_of(const std::function<FileMesh()>& read, const std::string& file) {
  try {
    return kMesh + bytes_of(read());
  } catch (const UserError& error) {
    return kRefusal + std::string(error.what());
  } catch (const std::exception& error) {
    return kRefusal + concat(file, ": can't be read: ", one_line(error.what()), kImportFix);
  }
}

template <class Value>
void append(std::string& bytes, const Value* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<Value>);
  const std::uint64_t size = count;
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}

void append(std::string& bytes, const std::vector<std::string>& texts) {
  const std::uint64_t count = texts.size();
  append(bytes, &count, 1);
  for (const std::string& text : texts) {
    append(bytes, text.data(), text.size());
  }
}

/// Reads the values that append() wrote, front to back.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  /// A std::vector or std::string. False if the bytes do not hold it.
  template <class Container>
  bool take(Container& values) {
    using Value = typename Container::value_type;
    std::uint64_t count = 0;
    if (rest_.size() < sizeof count) {
      return false;
    }
    std::memcpy(&count, rest_.data(), sizeof count);
    rest_.remove_prefix(sizeof count);
    if (count > rest_.size() / sizeof(Value)) {
      return false;
    }
    values.resize(static_cast<std::size_t>(count));
    const std::size_t size = values.size() * sizeof(Value);
    if (size != 0) {
      std::memcpy(static_cast<void*>(values.data()), rest_.data(), size);
    }
    rest_.remove_prefix(size);
    return true;
  }

  bool take(std::vector<std::string>& texts) {
    std::vector<std::uint64_t> count;
    if (!take(count) || count.size() != 1 || count[0] > rest_.size() / sizeof count[0]) {
      return false;
    }
    texts.resize(static_cast<std::size_t>(count[0]));
    return std::all_of(texts.begin(), texts.end(),
                       [this](std::string& text) { return take(text); });
  }

  bool is_empty() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

bool is_sound(const FileMesh& mesh) {
  const auto below = [](std::size_t limit) {
    return [limit](std::uint32_t index) { return index < limit; };
  };
  const auto corners_exist = [&](const bake::TriangleCorners& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), below(mesh.mesh.vertices.size()));
  };
  const auto is_point = [](const Position& point) {
    return std::all_of(point.begin(), point.end(), is_coordinate);
  };
  return !mesh.mesh.triangles.empty() && mesh.body_of.size() == mesh.mesh.triangles.size() &&
         std::isfinite(mesh.precision) && static_cast<std::uint8_t>(mesh.unit) < kUnitCount &&
         std::all_of(mesh.mesh.vertices.begin(), mesh.mesh.vertices.end(), is_point) &&
         std::all_of(mesh.mesh.triangles.begin(), mesh.mesh.triangles.end(), corners_exist) &&
         std::all_of(mesh.body_of.begin(), mesh.body_of.end(), below(mesh.bodies.size()));
}

}  // namespace

FileMesh guarded_import(const std::function<FileMesh()>& read, const std::string& file,
                        const ImportLimits& limits) {
  const auto read_and_send = [&](int to) { send(result_of(read, file), to); };
  const std::string result = guarded_bytes(read_and_send, file, limits, kImportFix);
  const std::string content = result.substr(1);
  const std::size_t colon = content.find(": ");
  if (result[0] == kRefusal && colon != std::string::npos) {
    throw UserError(content.substr(0, colon), content.substr(colon + 2));
  }
  std::optional<FileMesh> mesh = mesh_of_bytes(content);
  if (result[0] != kMesh || !mesh) {
    throw UserError(file, "can't be read: its reader gave no mesh", kImportFix);
  }
  return std::move(*mesh);
}

std::string bytes_of(const FileMesh& mesh) {
  std::string bytes;
  append(bytes, mesh.mesh.vertices.data(), mesh.mesh.vertices.size());
  append(bytes, mesh.mesh.triangles.data(), mesh.mesh.triangles.size());
  append(bytes, mesh.bodies);
  append(bytes, mesh.body_of.data(), mesh.body_of.size());
  append(bytes, &mesh.unit, 1);
  append(bytes, &mesh.precision, 1);
  append(bytes, mesh.warnings);
  return bytes;
}

std::optional<FileMesh> mesh_of_bytes(std::string_view bytes) {
  Unpacker unpacker(bytes);
  FileMesh mesh;
  std::vector<Unit> unit;
  std::vector<double> precision;
  const bool is_whole = unpacker.take(mesh.mesh.vertices) && unpacker.take(mesh.mesh.triangles) &&
                        unpacker.take(mesh.bodies) && unpacker.take(mesh.body_of) &&
                        unpacker.take(unit) && unit.size() == 1 && unpacker.take(precision) &&
                        precision.size() == 1 && unpacker.take(mesh.warnings) &&
                        unpacker.is_empty();
  if (!is_whole) {
    return std::nullopt;
  }
  mesh.unit = unit[0];
  mesh.precision = precision[0];
  return is_sound(mesh) ? std::optional<FileMesh>(std::move(mesh)) : std::nullopt;
}

}  // namespace flashbvh::tool
