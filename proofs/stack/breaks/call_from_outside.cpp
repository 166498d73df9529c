// A call of a function of C's library that calls.txt does not have.
#include <string.h>

const char* volatile text = "text";

int main() {
  return strcmp(text, text) == 0 ? 0 : 1;
}
