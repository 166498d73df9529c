/* Differences between the two languages that read the C headers. */
#pragma once

#if defined(__cplusplus) && __cplusplus < 201703L && !defined(_MSC_VER)
#error "flashbvh needs C++17: set -std=gnu++17"
#include <flashbvh_needs_cplusplus_17> /* there is none: compilers end here */
#endif

#include <stdbool.h> /* freestanding in C99; C++ callers see their own bool */
#include <stdint.h>

/* FLASHBVH_BYTE(Name) is the type of a field that holds an enumeration in one byte: flashbvh::Name
 * in C++; in C a number, one of the constants that the field's comment names. FLASHBVH_KEEP marks a
 * struct that C++ callers of a function must not drop. */
#ifdef __cplusplus
namespace flashbvh {
enum class ContactKind : uint8_t;
enum class QueryState : uint8_t;
enum class [[nodiscard]] Status : uint8_t;
}  // namespace flashbvh
#define FLASHBVH_BYTE(Name) flashbvh::Name
#define FLASHBVH_KEEP [[nodiscard]]
#else
#define FLASHBVH_BYTE(Name) uint8_t
#define FLASHBVH_KEEP
#endif

/* Marks a function whose result must not be dropped. */
#if defined(__GNUC__)
#define FLASHBVH_NODISCARD __attribute__((__warn_unused_result__))
#else
#define FLASHBVH_NODISCARD
#endif

/* Memory for a C++ object: a number of pointers and other bytes, aligned like a `Word`. */
#define FLASHBVH_OPAQUE(name, pointers, others, Word)             \
  typedef struct name {                                           \
    union {                                                       \
      unsigned char bytes[(pointers) * sizeof(void*) + (others)]; \
      Word word;                                                  \
      void* pointer;                                              \
    } opaque;                                                     \
  } name
