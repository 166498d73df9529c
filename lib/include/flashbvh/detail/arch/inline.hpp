// Inlining attributes, where the compiler's own judgement costs registers or stack.
#ifndef FLASHBVH_DETAIL_ARCH_INLINE_HPP
#define FLASHBVH_DETAIL_ARCH_INLINE_HPP

/// Walks are not inlined: in a function of its own, a loop gets the registers.
#if defined(__GNUC__)
#define FLASHBVH_NOINLINE [[gnu::noinline]]
/// What is small, and whose frame would stand in a query's way. A build may define it as nothing.
#if !defined(FLASHBVH_INLINE)
#define FLASHBVH_INLINE [[gnu::always_inline]]
#endif
/// The same unless size counts for more: what is there in several places.
#if defined(__OPTIMIZE_SIZE__)
#define FLASHBVH_INLINE_FOR_SPEED
#else
#define FLASHBVH_INLINE_FOR_SPEED FLASHBVH_INLINE
#endif
/// What makes a query, so that what is not read until it ends is left out; not on Xtensa, whose
/// frames grow by 16 bytes at a time.
#if defined(__XTENSA__)
#define FLASHBVH_INLINE_TO_RUN FLASHBVH_NOINLINE
#else
#define FLASHBVH_INLINE_TO_RUN FLASHBVH_INLINE_FOR_SPEED
#endif
#else
#define FLASHBVH_NOINLINE
#define FLASHBVH_INLINE
#define FLASHBVH_INLINE_FOR_SPEED
#define FLASHBVH_INLINE_TO_RUN
#endif

#endif
