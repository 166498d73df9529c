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

}  // namespace flashbvh::tool
