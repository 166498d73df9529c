// A frame whose size an argument sets.
volatile int size = 10;

__attribute__((noinline)) int sum(int count) {
  volatile char* const bytes = static_cast<char*>(__builtin_alloca(static_cast<unsigned>(count)));
  bytes[0] = 1;
  return bytes[count - 1];
}

int main() {
  return sum(size) & 0;
}
