// In a page with an open mesh, the library in it reports insides as not tested. `library`: as in pair_answers.js, whose
// KNOWN has the poses. Returns the first answer that says otherwise, or undefined.
const wrong_answer = library => {
  const words = (place, length) => new Int32Array(library.memory.buffer, place, length);
  const answers = KNOWN.map(([pose]) => {
    words(library.pose_words(), 15).set(pose);
    library.place();
    return [...words(library.measure(0, 1), 3)];
  });
  const apart = answers.filter(([, pairs]) => pairs === 0);
  return apart.length === 0 ? "none is apart" : apart.find(([, , inside]) => inside !== 2);
};
