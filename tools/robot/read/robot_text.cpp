#include "robot/read/robot_text.hpp"

#include <array>
#include <utility>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

template <class Value>
struct Word {
  Value value;
  const char* word;
};
constexpr Word<UrdfGeometry::Shape> kShapes[] = {{UrdfGeometry::Shape::box, "box"},
                                                 {UrdfGeometry::Shape::cylinder, "cylinder"},
                                                 {UrdfGeometry::Shape::sphere, "sphere"},
                                                 {UrdfGeometry::Shape::capsule, "capsule"},
                                                 {UrdfGeometry::Shape::ellipsoid, "ellipsoid"},
                                                 {UrdfGeometry::Shape::mesh, "mesh"},
                                                 {UrdfGeometry::Shape::triangles, "triangles"}};
constexpr Word<UrdfJoint::Type> kJointTypes[] = {{UrdfJoint::Type::fixed, "fixed"},
                                                 {UrdfJoint::Type::revolute, "revolute"},
                                                 {UrdfJoint::Type::continuous, "continuous"},
                                                 {UrdfJoint::Type::prismatic, "prismatic"}};

template <class Table, class Value>
const char* word_of(const Table& table, Value value) {
  for (const auto& [of, word] : table) {
    if (of == value) {
      return word;
    }
  }
  return "";
}

class Writer {
 public:
  std::string text() && { return std::move(text_); }

  template <class... Parts>
  void line(const char* word, const Parts&... parts) {
    text_ += word;
    (add(parts), ...);
    text_ += '\n';
  }

 private:
  void add(const std::string& part) { text_ += '\t' + one_line(part); }
  void add(const char* part) { text_ += concat("\t", part); }
  void add(double number) { text_ += '\t' + shortest(number); }
  void add(std::size_t number) { text_ += concat("\t", number); }
  void add(std::uint32_t number) { text_ += concat("\t", number); }
  template <class Value>
  void add(const std::array<Value, 3>& of) {
    for (const Value& value : of) {
      add(value);
    }
  }
  void add(const Transform& transform) {
    for (const Vector3& row : transform.rotation) {
      add(row);
    }
    add(transform.translation);
  }

  std::string text_;
};

void write(const char* word, const UrdfCollision& shape, Writer& writer) {
  const UrdfGeometry& geometry = shape.geometry;
  writer.line(word, word_of(kShapes, geometry.shape), shape.origin, geometry.size, geometry.radius,
              geometry.length, geometry.precision, geometry.mesh);
  for (const Vector3& vertex : geometry.triangles.vertices) {
    writer.line("vertex", vertex);
  }
  for (const bake::TriangleCorners& corners : geometry.triangles.triangles) {
    writer.line("triangle", corners);
  }
}

void write(const UrdfJoint& joint, Writer& writer) {
  writer.line("joint", joint.name, word_of(kJointTypes, joint.type), joint.parent, joint.child,
              joint.origin, joint.anchor, joint.axis, joint.lower, joint.upper);
  if (joint.mimic) {
    writer.line("mimic", joint.mimic->joint, joint.mimic->multiplier, joint.mimic->offset);
  }
}

/// Takes the parts of a line one by one; errors stick.
class Parts {
 public:
  explicit Parts(std::string_view line) : rest_(line) {}

  bool is_at_end() const { return is_good_ && is_empty_; }

  std::string_view take() {
    is_good_ = is_good_ && !is_empty_;
    const std::size_t tab = rest_.find('\t');
    const std::string_view part = rest_.substr(0, tab);
    is_empty_ = tab == std::string_view::npos;
    rest_.remove_prefix(is_empty_ ? rest_.size() : tab + 1);
    return part;
  }

  void take(std::string& text) { text = take(); }
  void take(double& number) {
    const std::optional<double> value = parse_number(take());
    is_good_ = is_good_ && value.has_value();
    number = value.value_or(0);
  }
  void take(std::uint32_t& number) {
    const long long value = parse_integer(take()).value_or(-1);
    is_good_ = is_good_ && value >= 0 && value <= 0xFFFFFFFF;
    number = static_cast<std::uint32_t>(value);
  }
  /// Takes a number below `limit`.
  void take_index(std::size_t& number, std::size_t limit) {
    std::uint32_t value = 0;
    take(value);
    is_good_ = is_good_ && value < limit;
    number = value;
  }
  template <class Value>
  void take(std::array<Value, 3>& of) {
    for (Value& value : of) {
      take(value);
    }
  }
  void take(Transform& transform) {
    for (Vector3& row : transform.rotation) {
      take(row);
    }
    take(transform.translation);
  }
  template <class Table, class Value>
  void take(const Table& table, Value& value) {
    const std::string_view part = take();
    for (const auto& [of, word] : table) {
      if (part == word) {
        value = of;
        return;
      }
    }
    is_good_ = false;
  }

 private:
  std::string_view rest_;
  bool is_good_ = true;
  bool is_empty_ = false;
};

class Reader {
 public:
  ReadRobot read;

  /// False if the line is malformed or out of place.
  bool take_line(std::string_view line) {
    Parts parts(line);
    const std::string_view word = parts.take();
    if (word == "robot") {
      parts.take(read.robot.name);
      parts.take_index(read.robot.root, 0xFFFFFFFF);
    } else if (word == "refusal") {
      parts.take(read.refusal);
    } else if (word == "warning") {
      parts.take(read.warnings.emplace_back().place);
      parts.take(read.warnings.back().what);
    } else if (word == "file") {
      parts.take(read.robot.files.emplace_back());
    } else if (word == "link") {
      parts.take(read.robot.links.emplace_back().name);
    } else if (word == "joint") {
      take_joint(parts);
    } else if (word == "mimic") {
      return take_mimic(parts);
    } else {
      return take_shape(word, parts);
    }
    return parts.is_at_end();
  }

 private:
  void take_joint(Parts& parts) {
    UrdfJoint& joint = read.robot.joints.emplace_back();
    parts.take(joint.name);
    parts.take(kJointTypes, joint.type);
    parts.take_index(joint.parent, read.robot.links.size());
    parts.take_index(joint.child, read.robot.links.size());
    parts.take(joint.origin);
    parts.take(joint.anchor);
    parts.take(joint.axis);
    parts.take(joint.lower);
    parts.take(joint.upper);
  }

  bool take_mimic(Parts& parts) {
    if (read.robot.joints.empty()) {
      return false;
    }
    UrdfMimic& mimic = read.robot.joints.back().mimic.emplace();
    parts.take(mimic.joint);
    parts.take(mimic.multiplier);
    parts.take(mimic.offset);
    return parts.is_at_end();
  }

  bool take_shape(std::string_view word, Parts& parts) {
    const bool is_visual = word == "visual";
    if ((is_visual || word == "collision") && !read.robot.links.empty()) {
      UrdfLink& link = read.robot.links.back();
      UrdfCollision& shape = (is_visual ? link.visuals : link.collisions).emplace_back();
      link.has_visual |= is_visual;
      geometry_ = &shape.geometry;
      parts.take(kShapes, geometry_->shape);
      parts.take(shape.origin);
      parts.take(geometry_->size);
      parts.take(geometry_->radius);
      parts.take(geometry_->length);
      parts.take(geometry_->precision);
      parts.take(geometry_->mesh);
    } else if (word == "vertex" && geometry_ != nullptr) {
      parts.take(geometry_->triangles.vertices.emplace_back());
    } else if (word == "triangle" && geometry_ != nullptr) {
      const std::size_t limit = geometry_->triangles.vertices.size();
      for (std::uint32_t& corner : geometry_->triangles.triangles.emplace_back()) {
        std::size_t index = 0;
        parts.take_index(index, limit);
        corner = static_cast<std::uint32_t>(index);
      }
    } else {
      return false;
    }
    return parts.is_at_end();
  }

  UrdfGeometry* geometry_ = nullptr;  ///< of the last link's last shape
};

}  // namespace

std::string text_of(const ReadRobot& read) {
  Writer writer;
  if (!read.refusal.empty()) {
    writer.line("refusal", read.refusal);
    return std::move(writer).text() + "end\n";
  }
  writer.line("robot", read.robot.name, read.robot.root);
  for (const PlacedWarning& warning : read.warnings) {
    writer.line("warning", warning.place, warning.what);
  }
  for (const std::string& file : read.robot.files) {
    writer.line("file", file);
  }
  for (const UrdfLink& link : read.robot.links) {
    writer.line("link", link.name);
    for (const UrdfCollision& shape : link.collisions) {
      write("collision", shape, writer);
    }
    for (const UrdfCollision& shape : link.visuals) {
      write("visual", shape, writer);
    }
  }
  for (const UrdfJoint& joint : read.robot.joints) {
    write(joint, writer);
  }
  return std::move(writer).text() + "end\n";
}

std::optional<ReadRobot> robot_of_text(std::string_view text) {
  Reader reader;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end + 1);
    if (line == "end") {
      const ReadRobot& read = reader.read;
      const bool is_whole = !read.refusal.empty() || read.robot.root < read.robot.links.size();
      return is_whole && text.empty() ? std::optional<ReadRobot>(std::move(reader.read))
                                      : std::nullopt;
    }
    if (!reader.take_line(line)) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace flashbvh::tool
