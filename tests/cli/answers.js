// Compares the library in a page with KNOWN, printed by live_answers.cpp. `arm`: exports of arm.cpp,
// with a robot open. Returns the first query with another answer, or undefined.
const wrong_answer = arm => ENDS.find(([lower, upper], variable) =>
  [[arm.lower, lower], [arm.upper, upper]].some(([end, wanted]) => {
    arm.set_value(variable, end(variable));
    return arm.coordinate_of(variable) !== wanted;
  })) || KNOWN.find(([values, wanted]) => {
  values.forEach((value, variable) => arm.set_coordinate(variable, value));
  const found = [arm.verdict(), arm.pair_of_answer(), arm.distance_of_answer()];
  return found.some((part, i) => part !== wanted[i]);
});
