/* Macros of Arduino, Windows, newlib, POSIX, CMSIS, the kits of vendors, and compilers for 8 and 16
 * bits. Those that other names must survive expand to what no code compiles with. The standard's
 * headers come first, as they do there. */
#include <ctype.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#ifdef __cplusplus
#include <new>
#endif

/* Function-like. */
#define abs(x) @
#define barrier() @
#define bit(b) @
#define bitRead(value, bit) @
#define byte(x) @
#define clamp(x, low, high) @
#define close(s) @
#define constrain(x, low, high) @
#define connect(s, name, length) @
#define container_of(pointer, type, member) @
#define degrees(rad) @
#define index(s, c) @
#define interrupts() @
#define likely(x) @
#define lowByte(w) @
#define max(a, b) @
#define min(a, b) @
#define radians(deg) @
#define read(s, memory, length) @
#define round(x) @
#define send(s, data, size, flags) @
#define sq(x) @
#define swap(a, b) @
#define unlikely(x) @
#define word(...) @
#define write(s, data, size) @
#define BIT(n) @
#define F(x) @
#define MAX(a, b) @
#define MIN(a, b) @

/* Object-like. */
#define far
#define near
#define huge
#define cdecl
#define eeprom @
#define hyper @
#define interface struct
#define interrupt @
#define linux 1
#define noinline __attribute__((noinline))
#define pascal
#define persistent @
#define ram @
#define rom const
#define small char
#define unix 1
#define B0 0
#define B1 1
#define CHANGE 1
#define CONST const
#define DEFAULT 1
#define DELETE 1
#define DISABLE 0
#define DONE 0
#define ENABLE 1
#define ERROR 0
#define EXTERNAL 0
#define FALSE 0
#define HIGH 1
#define I @
#define IN
#define INPUT 0
#define INTERNAL 3
#define LOW 0
#define OPAQUE 2
#define OPTIONAL
#define OUT
#define OUTPUT 1
#define PI 3.14
#define RELATIVE 2
#define RESET 0
#define SET 1
#define SUCCESS 0
#define TRUE 1
#define VOID void
