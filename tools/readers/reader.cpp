#include "readers/reader.hpp"

#include <unistd.h>

#include <cstdio>
#include <exception>

#include "text/numbers.hpp"

namespace flashbvh::tool {

void print_and_exit(const ReadRobot& read) {
  const std::string text = text_of(read);
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  _exit(is_written && std::fflush(stdout) == 0 ? 0 : 1);
}

void refuse_and_exit(const std::string& message) {
  ReadRobot read;
  read.refusal = message;
  print_and_exit(read);
}

void run_reader(int argc, char** argv, ReadRobot (*read)(const std::string& path)) {
  if (argc != 2) {
    std::fprintf(stderr, "%s FILE: reads a robot for flashbvh\n", argv[0]);
    _exit(2);
  }
  try {
    print_and_exit(read(argv[1]));
  } catch (const UserError& error) {
    refuse_and_exit(error.what());
  } catch (const std::exception& error) {
    refuse_and_exit(concat(argv[1], ": can't be read: ", error.what()));
  }
}

std::string place_of(const std::string& path, const char* kind, const std::string& name) {
  return concat(path, ", ", kind, " ", tool::quoted(name));
}

Transform transform_of(const std::array<double, 4>& quaternion, const Vector3& translation) {
  const auto [w, x, y, z] = quaternion;
  Transform transform;
  transform.rotation = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                         {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                         {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
  transform.translation = translation;
  return transform;
}

}  // namespace flashbvh::tool
