// The common includes of tests with a heap.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "support/rounds.hpp"

using namespace flashbvh;
using namespace flashbvh::test;
