// Meshes: a pair, of which the reader moves the second or steps through the page's poses; or one with its defects. Points
// and matrices are in cells of a mesh's frame (of two meshes, A's), relative to its origin; lengths and poses in the
// meshes' unit.

const ROTATION_ONE = 2 ** 30, FRACTION_ONE = 65536, FINE_ONE = 256;

// Rounds halves away from zero; clamps to the range of words, whose ends the library refuses.
const word_of = number => Math.min(Math.max(Math.sign(number) * Math.round(Math.abs(number)), -(2 ** 31)), 2 ** 31 - 1);

// Rotations about x, then y, then z, as in URDF, row by row; and their inverse.
const rotation_of = ([roll, pitch, yaw]) => {
  const [[a, b], [c, d], [e, f]] = [roll, pitch, yaw].map(angle => [Math.sin(angle), Math.cos(angle)]);
  return [f * d, f * c * a - e * b, f * c * b + e * a, e * d, e * c * a + f * b, e * c * b - f * a, -c, d * a, d * b];
};
const angles_of = r => [Math.atan2(r[7], r[8]), Math.asin(Math.min(Math.max(-r[6], -1), 1)), Math.atan2(r[3], r[0])];
const six_of = pose => [...pose.slice(9), ...angles_of(pose)];
const pose_of = text => text.trim().split(/\s+/).map(Number);

// The edges of triangles of nine numbers, as lines.
const edges_of = corners => {
  const edges = new Float32Array(2 * corners.length);
  for (let at = 0; at < corners.length; at += 9) {
    const [p, q, r] = [0, 3, 6].map(i => corners.subarray(at + i, at + i + 3));
    [p, q, q, r, r, p].forEach((end, i) => edges.set(end, 2 * at + 3 * i));
  }
  return edges;
};

// Opens { name, image, unit, marks } as the library's mesh number i.
const opened = (library, mesh, i) => {
  put(library, mesh.image, bytes => library.open_as_mesh(i, bytes));
  return { ...mesh, ...arrays_of(library, i), cell: library.cell_size(i), origin: words_at(library, library.origin(i), 3) };
};

class MeshStage extends Stage {
  constructor(section, mesh) {
    super(section, "The mesh", [mesh], [], "Drag the mesh to turn it.");
    this.mesh = mesh;
    this.say(0, mesh.name, `: ${mesh.triangles.length / 3} triangles`);
  }

  matrices() {
    return [IDENTITY];
  }
  colours() {
    return [this.colour("--inner")];
  }
  marks() {
    const { vertices, marks } = this.mesh;
    return marks.map(([colour, places]) => ({ kind: "LINES", colour: this.colour(colour),
      points: places.map(v => [...vertices.subarray(3 * v, 3 * v + 3)]) }));
  }
}

class PairStage extends Stage {
  // `meshes`: of the library; `pair`: { a, b, poses, names, verdicts }; poses are texts of 12 numbers and may be absent.
  constructor(section, library, meshes, { a, b, poses, names, verdicts }) {
    const [one, two] = [meshes[a], meshes[b]];
    const { cell, unit } = one;
    const trajectory = poses.length > 0 && new Trajectory(verdicts, "Pose", i => {
      const way = i > 0 ? this.#way(pose_of(poses[i - 1]), pose_of(poses[i])) : "";
      this.set(pose_of(poses[i]));
      return `${names[i]}: ${verdicts[i] === "4" ? "intersects" : "free"}${way}`;
    });
    const size = ({ vertices }) => 2 * Math.hypot(...vertices.reduce((most, at, i) => {
      most[i % 3] = Math.max(most[i % 3], Math.abs(at));
      return most;
    }, [0, 0, 0]));
    const far = cell * (size(one) + size(two) + Math.max(...one.origin.map((at, i) => Math.abs(at - two.origin[i]))));
    const lengths = [unit, unit || "in the meshes' unit", 1];
    const digits = Math.max(0, 1 - Math.floor(Math.log10(cell)));
    const sliders = ["x", "y", "z", "about x", "about y", "about z"].map((name, i) => {
      const set = value => {
        const six = this.six.with(i, value);
        this.set([...rotation_of(six.slice(3)), ...six.slice(0, 3)], six);
      };
      return i < 3 ? slider(name, -far, far, lengths, digits, set) : slider(name, -Math.PI, Math.PI, DEGREES, 2, set);
    });
    const text = element("textarea", { rows: 3, spellcheck: false, onchange: () => {
      const pose = pose_of(text.value);
      const is_valid = pose.length === 12 && pose.every(Number.isFinite);
      if (is_valid) this.set(pose);
      text.setCustomValidity(is_valid ? "" : "12 numbers are wanted");
      text.reportValidity();
    } });
    super(section, "Two meshes", [one, two], [...sliders.map(({ row }) => row), element("label", { className: "numbers" },
      element("span", { textContent: "pose of B in A's frame, a line of --poses" }), text)],
    `A is ${one.name}, B is ${two.name}. Drag B to move it, the ground to turn the view.`, trajectory);
    Object.assign(this, { library, a, b, one, two, cell, unit, sliders, text, far });
    this.set(pose_of(poses[0] || "1 0 0 0 1 0 0 0 1 0 0 0"));
  }

  // Sets 12 numbers. Keeps the six values that the user chose, so that angles are not recomputed while being set.
  set(pose, six = six_of(pose)) {
    Object.assign(this, { pose, six, status: this.#place(pose) });
    this.answer = this.status === 0 ? this.#measure() : { status: this.status };
    const { status, pairs, inside } = this.answer;
    this.#write(status !== 0 ? 5 : pairs > 0 || inside === 1 ? 4 : 0);
  }

  // Sets B's pose in A's frame: nine numbers of its rotation, three of its translation. Returns a Status.
  #place(pose) {
    const fractions = pose.slice(9).map(part => Math.sign(part) * Math.round(Math.abs(part) / this.cell * FRACTION_ONE));
    const cells = fractions.map(part => Math.floor((part + FRACTION_ONE / 2) / FRACTION_ONE));
    new Int32Array(this.library.memory.buffer, this.library.pose_words(), 15).set([
      ...pose.slice(0, 9).map(part => word_of(part * ROTATION_ONE)), ...cells.map(word_of),
      ...fractions.map((part, i) => part - cells[i] * FRACTION_ONE)]);
    return this.library.place();
  }

  // B's pose, moved to the right until it is free.
  free_pose() {
    const [right] = this.axes();
    const tried = i => this.pose.map((part, k) => (k < 9 ? part : part + i / 100 * this.far * right[k - 9]));
    const is_free = i => this.#place(tried(i)) === 0 && (({ pairs, inside }) => pairs === 0 && inside !== 1)(this.#measure());
    const i = Array.from({ length: 201 }, (_, k) => k).find(is_free);
    return i === undefined ? i : tried(i);
  }

  // The answers at B's pose. `corners`: of the triangles of the first intersecting pairs, alternately of A and B.
  #measure() {
    const place = this.library.measure(this.a, this.b);
    const [status, pairs, inside, in_range, lower, ...triangles] = words_at(this.library, place, 7);
    const points = doubles_at(this.library, place + 32, 6).map((part, i) => part - this.one.origin[i % 3]);
    return { status, pairs, inside, in_range, triangles, distance: (lower >>> 0) / FINE_ONE * this.cell,
      points: [points.slice(0, 3), points.slice(3)],
      corners: new Float32Array(words_at(this.library, this.library.lit_triangles(), 18 * Math.min(pairs, 1000))) };
  }

  // The straight motion from one pose to another, as text.
  #way(from, to) {
    this.#place(from);
    this.#place(to);
    const [status, outcome, end] = words_at(this.library, this.library.certify(this.a, this.b), 3);
    if (status !== 0) return "; the straight way there is not decided";
    const after = `after ${+(100 * end / 2 ** 30).toPrecision(3)} % of it`;
    return `; the straight way there ${["is free", `touches ${after}`, `comes close ${after}`][outcome]}`;
  }

  #write(verdict) {
    this.say(verdict, ...this.#text());
    this.sliders.forEach(({ show }, i) => show(this.six[i]));
    this.text.value = this.pose.map((part, i) => (i < 9 ? +part.toFixed(10) : +part.toPrecision(14)) + 0).join(" ");
  }

  // The verdict and details about it.
  #text() {
    const { status, pairs, inside, in_range, distance, triangles } = this.answer;
    const [a, b] = [this.one.name, this.two.name];
    if (status !== 0) return ["Refused", `: no pose, or out of range, status ${status}`];
    if (pairs) {
      return [`${b} intersects ${a}`, `: ${pairs === 100000 ? "at least " : ""}${pairs} pair${pairs > 1 ? "s" : ""} of triangles`];
    }
    const least = `${+distance.toPrecision(4)} ${this.unit} apart` + (in_range ? `, triangles ${triangles[0]} and ${triangles[1]}` : " at least");
    return [[`${b} does not touch ${a}`, `Of ${b} and ${a} one lies inside the other`,
      `${b} and ${a}: surfaces apart, insides not tested`][inside], inside === 1 ? `: their surfaces ${least}` : `: ${least}`];
  }

  // From the lattices to A's: A's own, and B's by its pose.
  matrices() {
    const { pose, one, two, cell } = this;
    const at = [0, 1, 2].map(i => [0, 1, 2].reduce((sum, j) => sum + pose[3 * i + j] * two.origin[j], pose[9 + i] / cell - one.origin[i]));
    return [IDENTITY, new Float32Array([0, 1, 2].flatMap(j => [pose[j], pose[3 + j], pose[6 + j], 0]).concat(at, 1))];
  }
  colours() {
    return [this.colour("--inner"), this.colour("--leaf")];
  }
  marks() {
    const { status, pairs, in_range, points, corners } = this.answer;
    if (status !== 0) return [];
    if (pairs === 0) return in_range ? this.line(points) : [];
    const [red, half] = [1, 0.6].map(alpha => [...this.colour("--v4").slice(0, 3), alpha]);
    return [{ kind: "TRIANGLES", points: corners, colour: half }, { kind: "LINES", points: edges_of(corners), colour: red }];
  }

  // B follows the pointer, as deep as it is.
  grab(mesh) {
    if (mesh !== 1) return undefined;
    const depth = -placed(this.view.eye(), this.matrices()[1].slice(12, 15))[2];
    const screen = this.view.screen();
    const { clientWidth, clientHeight } = this.canvas;
    return (x, y) => {
      const steps = [2 * x / clientWidth * depth / screen[0], -2 * y / clientHeight * depth / screen[5]];
      const [right, up] = this.axes();
      this.set(this.pose.map((part, i) => (i < 9 ? part : part + this.cell * (steps[0] * right[i - 9] + steps[1] * up[i - 9]))));
    };
  }
}
