#pragma once
#include <stdint.h>

extern "C" bool stdio_init_all();
extern "C" void sleep_ms(uint32_t milliseconds);
