// Arithmetic that not every core has; double, which fewer have.
double halved(double value) {
  return value * 0.5;
}
