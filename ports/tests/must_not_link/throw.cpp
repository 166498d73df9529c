int main(int argc, char**) {
  if (argc > 5) {
    throw argc;
  }
}
