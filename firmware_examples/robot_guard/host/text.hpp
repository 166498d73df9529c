// The board's text.hpp, on the host.
#pragma once

#include <iostream>

namespace port {

template <class... Values>
void print(Values... values) {
  (std::cout << ... << values);
}

}  // namespace port
