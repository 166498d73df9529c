// A call of a C library function that calls.txt does not list.
#include <string.h>

const char* volatile text = "text";

int main() {
  return strcmp(text, text) == 0 ? 0 : 1;
}
