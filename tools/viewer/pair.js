// Interactive meshes with firmware's library (pair.cpp). Points and matrices are in cells of a mesh's frame (of two
// meshes, A's), relative to its origin. Lengths and poses are in the meshes' unit.

const ROTATION_ONE = 2 ** 30, FRACTION_ONE = 65536, FINE_ONE = 256;

// Rounds halves away from zero; clamps to the range of words, whose ends the library refuses.
const word_of = number => Math.min(Math.max(Math.sign(number) * Math.round(Math.abs(number)), -(2 ** 31)), 2 ** 31 - 1);

class Meshes {
  static async from({ library, meshes }) {
    return new Meshes(await library_of(library), meshes);
  }

  // `meshes`: a list of { name, image, unit, marks }, the first two in base64.
  constructor(library, meshes) {
    this.library = library;
    this.all = meshes.map(({ name, image, unit, marks }, i) => {
      put(library, bytes_of(image), bytes => library.open(i, bytes));
      const arrays = arrays_of(library, i);
      const ends = pick => [0, 1, 2].map(axis =>
        arrays.vertices.reduce((end, at, v) => (v % 3 === axis ? pick(end, at) : end), -pick(-Infinity, Infinity)));
      const [lower, upper] = [ends(Math.min), ends(Math.max)];
      return { ...arrays, unit: unit && ` ${unit}`, marks, cell: library.cell_size(i), name: name_of(name), origin: this.#words(library.origin(i), 3),
        middle: lower.map((end, axis) => (end + upper[axis]) / 2), size: Math.hypot(...lower.map((end, axis) => upper[axis] - end)) };
    });
  }

  #words(place, count) {
    return [...new Int32Array(this.library.memory.buffer, place, count)];
  }
  #doubles(place, count) {
    return [...new Float64Array(this.library.memory.buffer, place, count)];
  }

  // Sets B's pose in A's frame: nine numbers of its rotation, three of its translation. Returns a Status.
  place(a, pose) {
    const fractions = pose.slice(9).map(part => Math.sign(part) * Math.round(Math.abs(part) / this.all[a].cell * FRACTION_ONE));
    const cells = fractions.map(part => Math.floor((part + FRACTION_ONE / 2) / FRACTION_ONE));
    new Int32Array(this.library.memory.buffer, this.library.pose_words(), 15).set([
      ...pose.slice(0, 9).map(part => word_of(part * ROTATION_ONE)), ...cells.map(word_of),
      ...fractions.map((part, i) => part - cells[i] * FRACTION_ONE)]);
    return this.library.place();
  }

  // A matrix from B's lattice to A's, column by column.
  matrix(a, b, pose) {
    const [from, to] = [this.all[b].origin, this.all[a].origin];
    const at = [0, 1, 2].map(i => [0, 1, 2].reduce((sum, j) => sum + pose[3 * i + j] * from[j], pose[9 + i] / this.all[a].cell - to[i]));
    return new Float32Array([0, 1, 2].flatMap(j => [pose[j], pose[3 + j], pose[6 + j], 0]).concat(at, 1));
  }

  // The answers for B at its pose. `lit`: the number of intersecting pairs with `corners` and `ids`, alternately of
  // triangles of A and B.
  measure(a, b) {
    const place = this.library.measure(a, b);
    const [status, pairs, inside, in_range, lower, ...triangles] = this.#words(place, 7);
    const points = this.#doubles(place + 32, 6).map((part, i) => part - this.all[a].origin[i % 3]);
    const lit = Math.min(pairs, 1000);
    const corners = new Float32Array(new Int32Array(this.library.memory.buffer, this.library.lit_triangles(), 18 * lit));
    return { status, pairs, inside: inside === 1, is_untested: inside === 2, in_range: in_range === 1, triangles, lower: lower >>> 0,
      distance: (lower >>> 0) / FINE_ONE * this.all[a].cell, points: [points.slice(0, 3), points.slice(3)],
      lit, corners, ids: this.#words(this.library.ids_of_lit(), 2 * lit) };
  }
  is_closer(a, b, length) {
    return this.library.is_closer(a, b, length) !== 0;
  }

  // B's straight motion from one pose to another. `outcome`: 0 free, 1 touches, 2 comes close; `share`: the
  // part of the motion before that. A status other than 0: undecided.
  way(a, b, from, to) {
    this.place(a, from);
    this.place(a, to);
    const [status, outcome, , end] = this.#words(this.library.certify(a, b), 4);
    return { status, outcome, share: end / 2 ** 30 };
  }

  // The first hit of the segment between two points, which are rounded to cells; or nothing.
  cast(mesh, from, to) {
    const { origin, triangles, vertices, cell } = this.all[mesh];
    const ends = [from, to].map(point => point.map((part, i) => word_of(part + origin[i])));
    new Int32Array(this.library.memory.buffer, this.library.segment_words(), 6).set(ends.flat());
    const place = this.library.cast(mesh);
    const [is_hit, triangle, slot, side, distance] = this.#words(place, 5);
    const point = this.#doubles(place + 24, 3);
    const corners = [...triangles.subarray(3 * slot, 3 * slot + 3)].map(v => [...vertices.subarray(3 * v, 3 * v + 3)]);
    return { ends, hit: is_hit === 1 && { triangle, side, corners, distance: distance / FINE_ONE * cell,
      point: point.map((part, i) => part - origin[i]), place: point.map(part => part * cell) } };
  }

  // "3.2 mm".
  length(mesh, value) {
    return `${+value.toPrecision(4)}${this.all[mesh].unit}`;
  }
}

// A text field for numbers that can be read, written and copied.
const numbers_field = (name, count, set) => {
  const text = element("textarea", { rows: 3, spellcheck: false });
  text.onchange = () => {
    const numbers = text.value.trim().split(/\s+/).map(Number);
    const is_valid = numbers.length === count && numbers.every(Number.isFinite);
    if (is_valid) set(numbers);
    text.setCustomValidity(is_valid ? "" : `${count} numbers are wanted`);
    text.reportValidity();
  };
  const copy = element("button", { textContent: "Copy", onclick: () => {
    text.select();
    document.execCommand("copy");
  } });
  return { text, row: element("label", { className: "numbers" }, element("span", { textContent: name }), text, copy) };
};
