// A function that calls itself through another one.
volatile int depth;

__attribute__((noinline)) void down();
__attribute__((noinline)) void up() {
  if (depth-- > 0) {
    down();
    depth = depth - 1;
  }
}
void down() {
  up();
  depth = depth + 1;
}

int main() {
  down();
  return 0;
}
