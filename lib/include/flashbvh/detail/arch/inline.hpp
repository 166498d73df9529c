// Inlining attributes, where the compiler's own judgement costs registers or stack.
#pragma once

/// Walks are not inlined: in a function of its own, a loop gets the registers.
#if defined(__GNUC__)
#define FLASHBVH_NOINLINE [[gnu::__noinline__]]
/// For small functions whose stack frame would add to a query's. A build may define it as nothing.
#if !defined(FLASHBVH_INLINE)
#define FLASHBVH_INLINE [[gnu::__always_inline__]]
#endif
/// FLASHBVH_INLINE except at -Os: for functions with several callers.
#if defined(__OPTIMIZE_SIZE__)
#define FLASHBVH_INLINE_FOR_SPEED
#else
#define FLASHBVH_INLINE_FOR_SPEED FLASHBVH_INLINE
#endif
/// For functions that make a query, so that compilers drop stores that are not read until it ends.
#define FLASHBVH_INLINE_TO_RUN FLASHBVH_INLINE_FOR_SPEED
#else
#define FLASHBVH_NOINLINE
#define FLASHBVH_INLINE
#define FLASHBVH_INLINE_FOR_SPEED
#define FLASHBVH_INLINE_TO_RUN
#endif
