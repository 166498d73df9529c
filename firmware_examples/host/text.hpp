// The host's text.hpp, in place of the board's.
#pragma once

#include <iostream>

namespace port {

template <class... Values>
void print(Values... values) {
  (std::cout << ... << values);
}

}  // namespace port
