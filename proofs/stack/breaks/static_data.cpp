// A counter that outlives its call.
int next_number() {
  static int number = 0;
  return ++number;
}
