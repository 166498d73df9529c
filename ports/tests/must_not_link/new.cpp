int* volatile kept;

int main() {
  kept = new int(3);
}
