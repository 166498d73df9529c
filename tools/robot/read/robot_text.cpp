#include "robot/read/robot_text.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

// In the order of the enumerators.
constexpr const char* kShapes[] = {"box",       "cylinder", "sphere",   "capsule",
                                   "ellipsoid", "mesh",     "triangles"};
constexpr const char* kJointTypes[] = {"fixed", "revolute", "continuous", "prismatic"};
static_assert(std::size(kShapes) == 1 + static_cast<std::size_t>(UrdfGeometry::Shape::triangles));
static_assert(std::size(kJointTypes) == 1 + static_cast<std::size_t>(UrdfJoint::Type::prismatic));

// The parts of lines, in order, for both directions: `line` writes them or takes them.

template <class Line, class Shape>
void pass_shape(Line& line, Shape& shape) {
  auto& geometry = shape.geometry;
  line.pass(geometry.shape, shape.origin, geometry.size, geometry.radius, geometry.length,
            geometry.precision, geometry.mesh);
}

template <class Line, class Joint>
void pass_joint(Line& line, Joint& joint) {
  line.pass(joint.name, joint.type, joint.parent, joint.child, joint.origin, joint.anchor,
            joint.axis, joint.lower, joint.upper);
}

template <class Line, class Mimic>
void pass_mimic(Line& line, Mimic& mimic) {
  line.pass(mimic.joint, mimic.multiplier, mimic.offset);
}

class Writer {
 public:
  std::string text() && { return std::move(text_) + "end\n"; }

  /// Begins a line; pass() ends it.
  Writer& begin(const char* word) {
    text_ += word;
    return *this;
  }
  template <class... Parts>
  void pass(const Parts&... parts) {
    (add(parts), ...);
    text_ += '\n';
  }

 private:
  void add(const std::string& part) { text_ += '\t' + one_line(part); }
  void add(UrdfGeometry::Shape shape) { add(kShapes[static_cast<std::size_t>(shape)]); }
  void add(UrdfJoint::Type type) { add(kJointTypes[static_cast<std::size_t>(type)]); }
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
    add(transform.rotation);
    add(transform.translation);
  }

  std::string text_;
};

void write(const char* word, const UrdfCollision& shape, Writer& writer) {
  pass_shape(writer.begin(word), shape);
  for (const Vector3& vertex : shape.geometry.triangles.vertices) {
    writer.begin("vertex").pass(vertex);
  }
  for (const bake::TriangleCorners& corners : shape.geometry.triangles.triangles) {
    writer.begin("triangle").pass(corners);
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
  template <class... Values>
  void pass(Values&... values) {
    (take(values), ...);
  }

 private:
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
  void take(std::size_t& number) {
    std::uint32_t value = 0;
    take(value);
    number = value;
  }
  template <class Value>
  void take(std::array<Value, 3>& of) {
    for (Value& value : of) {
      take(value);
    }
  }
  void take(Transform& transform) { pass(transform.rotation, transform.translation); }
  void take(UrdfGeometry::Shape& shape) { take(kShapes, shape); }
  void take(UrdfJoint::Type& type) { take(kJointTypes, type); }
  template <class Words, class Value>
  void take(const Words& words, Value& value) {
    const auto found = std::find(std::begin(words), std::end(words), take());
    is_good_ = is_good_ && found != std::end(words);
    value = static_cast<Value>(found - std::begin(words));
  }

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
    return take_content(word, parts) && parts.is_at_end();
  }

 private:
  /// Takes all parts after the word. False if the line is out of place, or names no link or vertex.
  bool take_content(std::string_view word, Parts& parts) {
    UrdfRobot& robot = read.robot;
    if (word == "robot") {
      parts.pass(robot.name, robot.root);
    } else if (word == "refusal") {
      parts.pass(read.refusal);
    } else if (word == "warning") {
      PlacedWarning& warning = read.warnings.emplace_back();
      parts.pass(warning.place, warning.what);
    } else if (word == "file") {
      parts.pass(robot.files.emplace_back());
    } else if (word == "link") {
      parts.pass(robot.links.emplace_back().name);
    } else if (word == "joint") {
      UrdfJoint& joint = robot.joints.emplace_back();
      pass_joint(parts, joint);
      return std::max(joint.parent, joint.child) < robot.links.size();
    } else if (word == "mimic" && !robot.joints.empty()) {
      pass_mimic(parts, robot.joints.back().mimic.emplace());
    } else {
      return take_shape(word, parts);
    }
    return true;
  }

  bool take_shape(std::string_view word, Parts& parts) {
    const bool is_visual = word == "visual";
    if ((is_visual || word == "collision") && !read.robot.links.empty()) {
      UrdfLink& link = read.robot.links.back();
      UrdfCollision& shape = (is_visual ? link.visuals : link.collisions).emplace_back();
      link.has_visual |= is_visual;
      geometry_ = &shape.geometry;
      pass_shape(parts, shape);
    } else if (word == "vertex" && geometry_ != nullptr) {
      parts.pass(geometry_->triangles.vertices.emplace_back());
    } else if (word == "triangle" && geometry_ != nullptr) {
      bake::TriangleCorners& corners = geometry_->triangles.triangles.emplace_back();
      parts.pass(corners);
      return *std::max_element(corners.begin(), corners.end()) <
             geometry_->triangles.vertices.size();
    } else {
      return false;
    }
    return true;
  }

  UrdfGeometry* geometry_ = nullptr;  ///< of the last link's last shape
};

}  // namespace

std::string text_of(const ReadRobot& read) {
  Writer writer;
  if (!read.refusal.empty()) {
    writer.begin("refusal").pass(read.refusal);
    return std::move(writer).text();
  }
  writer.begin("robot").pass(read.robot.name, read.robot.root);
  for (const PlacedWarning& warning : read.warnings) {
    writer.begin("warning").pass(warning.place, warning.what);
  }
  for (const std::string& file : read.robot.files) {
    writer.begin("file").pass(file);
  }
  for (const UrdfLink& link : read.robot.links) {
    writer.begin("link").pass(link.name);
    for (const UrdfCollision& shape : link.collisions) {
      write("collision", shape, writer);
    }
    for (const UrdfCollision& shape : link.visuals) {
      write("visual", shape, writer);
    }
  }
  for (const UrdfJoint& joint : read.robot.joints) {
    pass_joint(writer.begin("joint"), joint);
    if (joint.mimic) {
      pass_mimic(writer.begin("mimic"), *joint.mimic);
    }
  }
  return std::move(writer).text();
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
