// A call of a function that only the run knows.
void nothing() {}
void (*volatile function)() = nothing;

int main() {
  function();
  return 0;
}
