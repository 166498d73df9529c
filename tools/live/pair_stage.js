// Two meshes of a page: the user moves and turns B, or steps through the page's poses.

const MODES = ["move", "turn", "view"];

const product = (p, q) => Array.from({ length: 9 }, (_, at) =>
  [0, 1, 2].reduce((sum, k) => sum + p[3 * Math.floor(at / 3) + k] * q[3 * k + at % 3], 0));

// The rotation by an angle about an axis of length 1, row by row.
const rotation_about = ([x, y, z], angle) => {
  const [s, c] = [Math.sin(angle), Math.cos(angle)], d = 1 - c;
  return [c + d * x * x, d * x * y - s * z, d * x * z + s * y, d * x * y + s * z, c + d * y * y, d * y * z - s * x,
    d * x * z - s * y, d * y * z + s * x, c + d * z * z];
};

// Rotations about x, then y, then z, as in URDF, and their inverse.
const rotation_of = ([roll, pitch, yaw]) => product(rotation_about([0, 0, 1], yaw),
  product(rotation_about([0, 1, 0], pitch), rotation_about([1, 0, 0], roll)));
const angles_of = r => [Math.atan2(r[7], r[8]), Math.asin(Math.min(Math.max(-r[6], -1), 1)), Math.atan2(r[3], r[0])];
const six_of = pose => [...pose.slice(9), ...angles_of(pose)];

// The edges of triangles of nine numbers, as lines.
const edges_of = corners => {
  const edges = new Float32Array(2 * corners.length);
  for (let at = 0; at < corners.length; at += 9) {
    edges.set(corners.subarray(at, at + 6), 2 * at);
    edges.set(corners.subarray(at + 3, at + 9), 2 * at + 6);
    edges.set(corners.subarray(at + 6, at + 9), 2 * at + 12);
    edges.set(corners.subarray(at, at + 3), 2 * at + 15);
  }
  return edges;
};

class PairStage extends Stage {
  // `pair`: { a, b, poses, names, verdicts }; poses are texts of 12 numbers and may be absent.
  constructor(section, meshes, { a, b, poses, names, verdicts }) {
    super(section, "Two meshes. Arrow keys move the second, page up and page down too; with Shift they turn it, with Alt " +
      "the view; plus and minus come nearer and go away.");
    const { cell, unit } = meshes.all[a];
    Object.assign(this, { meshes, a, b, cell, unit, limit: 0, names: [a, b].map(mesh => meshes.all[mesh].name) });
    const pose_of = text => text.split(" ").map(Number);
    this.pose = pose_of(poses[0] || "1 0 0 0 1 0 0 0 1 0 0 0");
    this.six = six_of(this.pose);
    this.trajectory = poses.length > 0 && new Trajectory(verdicts, "Pose", i => {
      const way = i > 0 ? this.#way(pose_of(poses[i - 1]), pose_of(poses[i])) : "";
      this.set(pose_of(poses[i]));
      return `${names[i]}: ${verdicts[i] === "3" ? "intersects" : "free"}${way}`;
    });
    const [one, two] = [meshes.all[a], meshes.all[b]];
    const far = cell * (one.size + two.size + Math.max(...one.origin.map((at, i) => Math.abs(at - two.origin[i]))));
    const lengths = [unit, unit || "in the meshes' unit", 1];
    const digits = Math.max(0, 1 - Math.floor(Math.log10(cell)));
    this.sliders = ["x", "y", "z", "about x", "about y", "about z"].map((name, i) => (i < 3 ?
      slider(name, -far, far, lengths, digits, value => this.#set_number(i, value)) :
      slider(name, -Math.PI, Math.PI, DEGREES, 2, value => this.#set_number(i, value))));
    this.field = numbers_field("pose of B in A's frame, a line of --poses", 12, numbers => this.set(numbers));
    this.list = element("p", { className: "note" });
    this.box = this.lay_out(this.trajectory && this.trajectory.bar,
      [this.#modes(), ...this.sliders.map(({ row }) => row), this.#limit(), this.field.row, this.list],
      `A is ${one.name}, B is ${two.name}. Drag B to move it, with Shift to turn it; drag the ground to turn the view.` + OWN_CODE);
  }

  show() {
    this.#place();
    this.open([this.a, this.b].map(mesh => this.meshes.all[mesh]));
    this.update();
    if (this.trajectory) this.trajectory.attach(this.section);
  }

  #modes() {
    this.mode = "move";
    const choices = MODES.map(mode => element("label", {}, element("input", { type: "radio", name: "mode", value: mode,
      checked: mode === this.mode, onchange: () => { this.mode = mode; } }), mode));
    return element("fieldset", { className: "modes" }, element("legend", { textContent: "Dragging B, and arrow keys" }), ...choices);
  }
  #limit() {
    this.limit_input = element("input", { type: "number", min: 0, step: "any", value: 0 });
    this.limit_input.onchange = () => {
      this.limit = Math.max(0, +this.limit_input.value);
      this.update();
    };
    return element("div", { className: "distances" },
      element("label", {}, element("span", { textContent: "closer than" }), this.limit_input, this.unit));
  }

  // Sets 12 numbers. Keeps the six values that the user chose, so that angles are not recomputed while being set.
  set(pose, six = six_of(pose)) {
    this.pose = pose;
    this.six = six;
    this.update();
  }
  #set_number(i, value) {
    const six = this.six.map((number, j) => (i === j ? value : number));
    this.set([...rotation_of(six.slice(3)), ...six.slice(0, 3)], six);
  }

  #place() {
    this.status = this.meshes.place(this.a, this.pose);
    this.matrix = this.meshes.matrix(this.a, this.b, this.pose);
  }
  update() {
    this.#place();
    this.answer = this.status === 0 ? this.meshes.measure(this.a, this.b) : { status: this.status };
    const { status, pairs, inside } = this.answer;
    this.closer = this.limit > 0 && this.meshes.is_closer(this.a, this.b, this.limit);
    this.answered(this.verdict = status !== 0 ? 4 : pairs > 0 || inside ? 3 : this.closer ? 1 : 0);
  }

  write() {
    const { pairs, lit, ids } = this.answer;
    this.say(this.verdict, ...this.#text());
    this.sliders.forEach(({ show }, i) => show(this.six[i]));
    if (document.activeElement !== this.field.text) {
      this.field.text.value = this.pose.map((part, i) => (i < 9 ? +part.toFixed(10) : +part.toPrecision(14)) + 0).join(" ");
    }
    const named = Array.from({ length: Math.min(lit, 12) }, (_, i) => `${ids[2 * i]} and ${ids[2 * i + 1]}`);
    this.list.textContent = pairs ? `Triangles of ${this.names.join(" and ")}: ${named.join(", ")}` +
      (pairs > 12 ? ` \u2026${lit < pairs ? ` The first ${lit} pairs are drawn.` : ""}` : "") : "";
  }

  // The motion from the last pose, as text.
  #way(from, to) {
    const { status, outcome, share } = this.meshes.way(this.a, this.b, from, to);
    if (status !== 0) return "; the straight way there is not decided";
    const after = `after ${+(100 * share).toPrecision(3)} % of it`;
    return `; the straight way there ${["is free", `touches ${after}`, `comes close ${after}`][outcome]}`;
  }

  // The verdict and details about it.
  #text() {
    const { status, pairs, inside, is_untested, in_range, distance, triangles } = this.answer;
    const [a, b] = this.names;
    if (status !== 0) return ["Refused", `: no pose, or out of range, status ${status}`];
    if (pairs) {
      return [`${b} intersects ${a}`, `: ${pairs === 100000 ? "at least " : ""}${pairs} pair${pairs > 1 ? "s" : ""} of triangles`];
    }
    const length = this.meshes.length(this.a, distance);
    const least = in_range ? `, triangles ${triangles[0]} and ${triangles[1]}` : " at least";
    if (inside) return [`Of ${b} and ${a} one lies inside the other`, `: their surfaces ${length} apart${least}`];
    return [is_untested ? `${b} and ${a}: surfaces apart, insides not tested` : `${b} does not touch ${a}`, `: ${length} apart${least}` +
      (this.limit > 0 ? `; ${this.closer ? "closer" : "not closer"} than ${this.meshes.length(this.a, this.limit)}` : "")];
  }

  matrices() {
    return [IDENTITY, this.matrix];
  }
  colours() {
    return [this.colour("--inner"), this.colour("--leaf")];
  }
  marks() {
    const { status, pairs, in_range, points, corners } = this.answer;
    if (status !== 0) return [];
    if (pairs === 0) return in_range ? this.line(points) : [];
    const [red, half] = [1, 0.6].map(alpha => [...this.colour("--v3").slice(0, 3), alpha]);
    return [{ kind: "TRIANGLES", points: corners, colour: half }, { kind: "LINES", points: edges_of(corners), colour: red }];
  }

  // Moves along the axes(), in cells.
  #move(steps) {
    const way = [0, 1, 2].map(i => this.axes().reduce((sum, axis, k) => sum + axis[i] * steps[k], 0) * this.cell);
    this.set(this.pose.map((part, i) => (i < 9 ? part : part + way[i - 9])));
  }
  // Turns about one of these axes through B's centre, which stays in place.
  #spin(axis, angle) {
    const { middle, origin } = this.meshes.all[this.b];
    const at = r => [0, 1, 2].map(i => [0, 1, 2].reduce((sum, j) => sum + r[3 * i + j] * (middle[j] + origin[j]), 0) * this.cell);
    const before = this.pose.slice(0, 9);
    // Conversion to angles and back keeps a product of many turns a rotation.
    const turned = rotation_of(angles_of(product(rotation_about(this.axes()[axis], angle), before)));
    const [from, to] = [at(before), at(turned)];
    this.set([...turned, ...this.pose.slice(9).map((part, i) => part + from[i] - to[i])]);
  }

  #mode_of({ shiftKey, altKey }) {
    return shiftKey ? "turn" : altKey ? "view" : this.mode;
  }
  grab(mesh, _, event) {
    const mode = this.#mode_of(event);
    if (mesh !== 1 || mode === "view") return undefined;
    if (mode === "turn") {
      return (x, y) => {
        this.#spin(1, x / 150);
        this.#spin(0, y / 150);
      };
    }
    const { middle } = this.meshes.all[this.b];
    const depth = -placed(this.view.eye(), placed(this.matrix, middle))[2];
    const screen = this.view.screen();
    const { clientWidth, clientHeight } = this.canvas;
    return (x, y) => this.#move([2 * x / clientWidth * depth / screen[0], -2 * y / clientHeight * depth / screen[5], 0]);
  }
  key(event) {
    const mode = this.#mode_of(event);
    const [x, y, z] = [...KEYS[event.key] || [0, 0], { PageUp: -1, PageDown: 1 }[event.key] || 0];
    if (mode === "view" || !(x || y || z)) return super.key(event);
    const step = this.meshes.all[this.b].size / 50;
    if (mode === "move") this.#move([x * step, y * step, z * step]);
    else this.#spin(x ? 1 : y ? 0 : 2, 0.05 * (x - y + z));
    return true;
  }
}
