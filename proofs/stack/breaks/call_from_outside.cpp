// A call of a C library function that stack.txt does not list.
#include <string.h>

const char* volatile text = "text";

int main() {
  return strcmp(text, text) == 0 ? 0 : 1;
}
