// A hash of what guards that know nothing yet say of rows of joint values, and how often they say each verdict.
const hashed = answers => {
  let hash = 2166136261;
  const verdicts = [0, 0, 0, 0, 0];
  for (const [verdict, pair, distance] of answers) {
    ++verdicts[verdict];
    for (const word of [verdict, pair, distance]) hash = Math.imul(hash ^ word, 16777619) >>> 0;
  }
  return `${hash}: ${verdicts[0]} free, ${verdicts[1]} warn, ${verdicts[3]} stop`;
};

// Of the library of a page: exports of arm.cpp, a robot opened.
const answers_of = (arm, values) => {
  const count = arm.variable_count();
  return hashed(Array.from({ length: values.length / count }, (_, row) => {
    for (let i = 0; i < count; ++i) arm.set_coordinate(i, values[row * count + i]);
    arm.place();
    return [arm.verdict(), arm.pair_of_answer(), arm.distance_of_answer()];
  }));
};
