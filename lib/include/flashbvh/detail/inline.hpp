// What the compiler is told of inlining, where its own judgement costs registers or stack.
#ifndef FLASHBVH_DETAIL_INLINE_HPP
#define FLASHBVH_DETAIL_INLINE_HPP

/// Walks are not inlined: in a function of its own, a loop gets the registers.
#if defined(__GNUC__)
#define FLASHBVH_NOINLINE [[gnu::noinline]]
/// What is small, and whose frame would stand in a query's way.
#define FLASHBVH_INLINE [[gnu::always_inline]]
/// The same unless size counts for more: what is there in several places.
#if defined(__OPTIMIZE_SIZE__)
#define FLASHBVH_INLINE_FOR_SPEED
#else
#define FLASHBVH_INLINE_FOR_SPEED FLASHBVH_INLINE
#endif
#else
#define FLASHBVH_NOINLINE
#define FLASHBVH_INLINE
#define FLASHBVH_INLINE_FOR_SPEED
#endif

#endif
