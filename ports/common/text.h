/* Text output for firmware in C: text.hpp's, for strings and numbers. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

void port_put(const char* text);
void port_put_number(long value);

#ifdef __cplusplus
}
#endif
