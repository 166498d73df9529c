// Compares the library in a page with KNOWN, printed by live_pair_answers.cpp. `library`: exports of
// pair.cpp, with two images open. Returns the first query with another answer, or undefined.
const wrong_answer = library => {
  const words = (place, length) => new Int32Array(library.memory.buffer, place, length);
  library.measure(1, 0);  // forgets the hint of (0, 1)
  return KNOWN.find(([pose, segment, wanted]) => {
    words(library.pose_words(), 15).set(pose);
    library.place();
    const place = library.measure(0, 1);
    const [, pairs, inside, , lower, a, b] = words(place, 7);
    const points = new Float64Array(library.memory.buffer, place + 32, 6).map(part => 256 * part);
    words(library.segment_words(), 6).set(segment);
    const [is_hit, triangle] = words(library.cast(0), 2);
    const found = [pairs, inside, library.is_closer(0, 1, LIMIT), is_hit, lower, a, b, points[0], points[5], triangle];
    if (wanted.length > found.length) {
      const [, outcome, , to] = words(library.certify(0, 1), 4);
      found.push(outcome, to);
    }
    return found.some((part, i) => part !== wanted[i]);
  });
};
