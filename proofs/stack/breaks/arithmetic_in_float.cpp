// Arithmetic with a double, for which even cores with an FPU call library functions.
unsigned long long whole(double value) {
  return static_cast<unsigned long long>(value);
}
