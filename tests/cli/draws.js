// The generator and the hash of draws.hpp: numbers of 24 bits, and a hash of the added ones.
const drawing = () => {
  let state = 1, hash = 2166136261;
  return {
    next: () => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return state >>> 8;
    },
    add: word => { hash = Math.imul(hash ^ word, 16777619) >>> 0; },
    hash: () => hash };
};
