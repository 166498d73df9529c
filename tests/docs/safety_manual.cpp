// The C++ of the safety manual, which snippets.py writes: it compiles.
#include "safety_manual_05.cpp"

int main() {
  return &may_go == nullptr ? 1 : 0;
}
