// Arithmetic with a double that even cores with an FPU for it call for.
unsigned long long whole(double value) {
  return static_cast<unsigned long long>(value);
}
