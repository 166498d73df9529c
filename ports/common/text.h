/* Text output for firmware in C: strings and numbers, by text.hpp. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

void port_put(const char* text);
void port_put_number(long value);

#ifdef __cplusplus
}
#endif
