// A call of a function that is known only at run time.
void nothing() {}
void (*volatile function)() = nothing;

int main() {
  function();
  return 0;
}
