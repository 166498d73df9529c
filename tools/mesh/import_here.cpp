// Replaces guarded_import.cpp and guarded_child.cpp where there are no processes: runs the reader
// in this one. A crash ends the program, with a message and the exit code of a file that can't be
// read.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include "mesh/guarded_import.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

std::string crash;  // the message on a crash

[[noreturn]] void end_by_crash(int) {
  std::fputs(crash.c_str(), stderr);
  std::_Exit(2);
}

}  // namespace

FileMesh guarded_import(const std::function<FileMesh()>& read, const std::string& file,
                        const ImportLimits&) {
  crash = one_line(concat("flashbvh: ", file, ": can't be read: its reader crashed", kImportFix)) +
          "\n";
  for (const int signal : {SIGABRT, SIGFPE, SIGILL, SIGSEGV}) {
    std::signal(signal, end_by_crash);
  }
  try {
    return read();
  } catch (const UserError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw UserError(file, "can't be read: takes more memory than there is", kImportFix);
  } catch (const std::exception& error) {
    throw UserError(file, "can't be read: ", one_line(error.what()), kImportFix);
  }
}

}  // namespace flashbvh::tool
