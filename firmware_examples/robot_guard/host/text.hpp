// The board's text.hpp, on the host.
#ifndef FLASHBVH_ROBOT_GUARD_TEXT_HPP
#define FLASHBVH_ROBOT_GUARD_TEXT_HPP

#include <iostream>

namespace port {

template <class... Values>
void print(Values... values) {
  (std::cout << ... << values);
}

}  // namespace port

#endif
