/* What differs between the two languages that read plain data. */
#ifndef FLASHBVH_PLAIN_LANGUAGE_H
#define FLASHBVH_PLAIN_LANGUAGE_H

#include <stdbool.h> /* freestanding in C99; C++ callers see their own bool */
#include <stdint.h>

/* FLASHBVH_BYTE(Name) is the type of a field that holds an enumeration in one byte: in C++
 * flashbvh::Name, in C a number, one of the constants that the field's comment names.
 * FLASHBVH_KEEP marks a struct that C++ callers of a function must not drop. */
#ifdef __cplusplus
namespace flashbvh {
enum class ContactKind : uint8_t;
enum class JointType : uint8_t;
enum class WhyUnguarded : uint8_t;
enum class [[nodiscard]] Status : uint8_t;
enum class [[nodiscard]] Verdict : uint8_t;
enum class [[nodiscard]] MotionOutcome : uint8_t;
}  // namespace flashbvh
#define FLASHBVH_BYTE(Name) flashbvh::Name
#define FLASHBVH_KEEP [[nodiscard]]
#else
#define FLASHBVH_BYTE(Name) uint8_t
#define FLASHBVH_KEEP
#endif

#endif
