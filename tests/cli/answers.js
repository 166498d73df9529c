// The output of live_answers.cpp, from the library in a page: exports of arm.cpp, with a robot
// open.
const answers_of = (arm, count) => {
  const { next, add, hash } = drawing();
  const ends = [];
  for (let variable = 0; variable < arm.variable_count(); ++variable) {
    ends.push([arm.lower, arm.upper].map(end => {
      arm.set_value(variable, end(variable));
      return arm.coordinate_of(variable);
    }));
  }
  const verdicts = [0, 0, 0, 0, 0];
  for (let i = 0; i < count; ++i) {
    ends.forEach(([lower, upper], variable) =>
      arm.set_coordinate(variable, lower + Math.floor((upper - lower) * next() / 2 ** 24)));
    arm.place();
    const verdict = arm.verdict();
    ++verdicts[verdict];
    [verdict, arm.pair_of_answer(), arm.distance_of_answer()].forEach(add);
  }
  return `${hash()}: ${verdicts[0]} free, ${verdicts[1]} warn, ${verdicts[3]} stop`;
};
