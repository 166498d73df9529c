#include <stdlib.h>

void app_main(void);

int main(void) {
  app_main();
  exit(0);
}
