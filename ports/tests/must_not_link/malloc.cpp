#include <stdlib.h>

void* volatile kept;

int main() {
  kept = malloc(4);
}
