volatile bool is_wrong;

int main() {
  if (is_wrong) {
    throw 1;
  }
}
