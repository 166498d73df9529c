// The output of live_pair_answers.cpp, from the library in a page: exports of pair.cpp, with two
// images opened.
const answers_of = (library, count) => {
  const SPAN = 2 ** 14, LIMIT = 2 ** 20, WAYS = 16;
  const { next, add, hash } = drawing();
  const below = end => Math.floor(next() * end / 2 ** 24);
  const words = (place, length) => new Int32Array(library.memory.buffer, place, length);
  const origin = mesh => [...words(library.origin(mesh), 3)];
  const [from, to] = [origin(0), origin(1)];
  const draw_pose = () => {
    let [w, x, y, z] = [1, 2, 3, 4].map(() => below(2001) - 1000);
    w += w === 0 ? 1 : 0;
    const square = w * w + x * x + y * y + z * z;
    const over = [w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w),
      2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w),
      2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z];
    const shift = from.map((at, i) => [at - to[i] - SPAN + below(2 * SPAN), below(65536) - 32768]);
    words(library.pose_words(), 15).set([...over.map(entry => Math.trunc(entry * 2 ** 30 / square)),
      ...shift.map(([cells]) => cells), ...shift.map(([, fraction]) => fraction)]);
    library.place();
  };
  const counts = [0, 0, 0, 0, 0];
  library.measure(1, 0);  // forgets the hint of (0, 1)
  for (let i = 0; i < count; ++i) {
    draw_pose();
    const place = library.measure(0, 1);
    const [, pairs, inside, , lower, a, b] = words(place, 7);
    const points = new Float64Array(library.memory.buffer, place + 32, 6).map(part => 256 * part);
    const closer = library.is_closer(0, 1, LIMIT);
    words(library.segment_words(), 6).set([...from, ...from].map(at => at - 2 * SPAN + below(4 * SPAN)));
    const [is_hit, triangle] = words(library.cast(0), 2);
    [pairs !== 0, inside, closer, is_hit].forEach((holds, k) => { counts[k] += +holds; });
    [pairs, inside, lower, a, b, points[0], points[5], closer, is_hit ? triangle + 1 : 0].forEach(add);
    if (i % WAYS === WAYS - 1) {
      const [, outcome, , to] = words(library.certify(0, 1), 4);
      counts[4] += outcome === 0 ? 1 : 0;
      [outcome, to].forEach(add);
    }
  }
  return `${hash()}: ${counts[0]} intersect, ${counts[1]} inside, ${counts[2]} closer, ${counts[3]} hit, ${counts[4]} ways free`;
};
