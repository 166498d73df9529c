// A robot that the reader moves, or its trajectory. Numbers are radians and metres.

const VERDICTS = ["free", "warn", "leaving", "not yet known", "stops", "refused"];
const NO_MESH = { vertices: new Int16Array(), triangles: new Uint16Array() };

class RobotStage extends Stage {
  // `zones`: for each a joint, a point in cells of its frame, and a radius in metres. With `names` there are positions:
  // their values, one after the other, and their verdicts, a digit each.
  constructor(section, library, { image, zones, names, values, verdicts }) {
    put(library, image, bytes => library.open_as_robot(bytes));
    const each = (count, make) => Array.from({ length: count }, (_, i) => make(i));
    const text = place => {
      const memory = new Uint8Array(library.memory.buffer);
      return new TextDecoder().decode(memory.subarray(place, memory.indexOf(0, place)));
    };
    const variables = each(library.variable_count(), i => ({
      name: text(library.variable_name(i)), slides: library.is_slide(i) !== 0, lower: library.lower(i), upper: library.upper(i) }));
    const links = each(library.link_count(), i => ({ name: text(library.name_of_link(i)), variable: library.variable_of_link(i) }));
    // A part of a link, used near a joint, has the link's name and a higher index; it is not drawn.
    links.forEach(link => { link.whole = links.findIndex(({ name }) => name === link.name); });
    const sliders = variables.map(({ name, lower, upper, slides }, i) =>
      slider(name, lower, upper, slides ? ["mm", "millimetres", 1000] : DEGREES, slides ? 3 : 2, value => this.set(this.values.with(i, value))));
    const numbers = names && new Float32Array(bytes_of(values).buffer);
    const trajectory = names && new Trajectory(verdicts, "Period", period => {
      this.set([...numbers.slice(variables.length * period, variables.length * (period + 1))]);
      return `${names[period]}: ${VERDICTS[verdicts[period]]} on the way`;
    });
    super(section, "The robot", links.map(({ whole }, i) => (whole === i ? arrays_of(library, i) : NO_MESH)),
      sliders.map(({ row }) => row), "Drag a link to move its joint, the ground to turn the robot." +
      (zones.length > 0 ? " Dashed: joint zones, in which neighbours may touch and no guard looks." : ""), trajectory);
    Object.assign(this, { library, zones, variables, links, sliders });
    this.set(variables.map(({ lower, upper }) => Math.min(Math.max(0, lower), upper)));
  }

  #place() {
    this.values.forEach((value, i) => this.library.set_value(i, value));
    this.library.place_links();
    const matrix = place => new Float32Array(doubles_at(this.library, place, 16));
    this.placed = this.links.map((_, i) => matrix(this.library.matrix_of(i)));
    this.balls = this.zones.map(([joint, x, y, z, radius]) => (
      { middle: placed(matrix(this.library.matrix_of_joint(joint)), [x, y, z]).slice(0, 3), radius }));
  }

  // Values for all variables, each within its limits.
  set(values) {
    this.values = this.variables.map(({ lower, upper }, i) => Math.min(Math.max(values[i], lower), upper));
    this.#place();
    const [verdict, ...pair] = words_at(this.library, this.library.verdict(), 3);
    const links = pair.filter(link => link >= 0);
    this.answer = { verdict, links: links.map(link => this.links[link].whole), nearest: this.#nearest(),
      is_outside: links.some(link => this.links[link].whole !== link) };
    this.#write();
  }

  // The nearest to the present values of many random ones, at which the guard says free; or undefined.
  free_pose() {
    const { values, variables } = this;
    for (let i = 0; i <= 1000; ++i) {
      const tried = variables.map(({ lower, upper }, k) => (
        Math.min(Math.max(values[k] + i / 1000 * (2 * Math.random() - 1) * (upper - lower), lower), upper)));
      tried.forEach((value, k) => this.library.set_value(k, value));
      if (words_at(this.library, this.library.verdict(), 1)[0] === 0) return tried;
    }
    return undefined;
  }

  // Of all guarded pairs, but for neighbours outside their zone: metres, two points, two links; or null.
  #nearest() {
    const place = this.library.nearest_links(new Set(this.links.map(({ whole }) => whole)).size);
    if (!place) return null;
    const [metres, ...points] = doubles_at(this.library, place, 7);
    return { metres, line: [points.slice(0, 3), points.slice(3)], links: words_at(this.library, place + 56, 2) };
  }

  #write() {
    const { verdict, links, nearest, is_outside } = this.answer;
    const names = two => two.map(i => this.links[i].name).join(" \u2013 ");
    const where = links.length > 0 && verdict !== 0 ? `: ${names(links)}${is_outside ? " outside their zone" : ""}` : "";
    const least = nearest ? `: ${names(nearest.links)}` : "";
    this.say(verdict, VERDICTS[verdict], where + (where === least ? "" : `${where && ". Nearest"}${least}`) +
      (nearest ? `, ${(1000 * nearest.metres).toFixed(1)} mm apart` : ""));
    this.sliders.forEach(({ show }, i) => show(this.values[i]));
  }

  matrices() {
    return this.placed;
  }
  colours() {
    const { verdict, links } = this.answer;
    const plain = [this.colour("--inner"), this.colour("--leaf")];
    return this.links.map((_, i) => (verdict !== 0 && links.includes(i) ? this.colour(`--v${verdict}`) : plain[i % 2]));
  }
  marks() {
    const zones = this.balls.map(ball => ({ kind: "LINES", points: this.#dashes(ball), colour: this.colour("--accent") }));
    return [...zones, ...this.answer.nearest ? this.line(this.answer.nearest.line) : []];
  }

  // The approximate outline of a ball.
  #dashes({ middle, radius }) {
    const [right, up] = this.axes();
    return Array.from({ length: 64 }, (_, i) => {
      const [s, c] = [Math.sin(i * Math.PI / 32), Math.cos(i * Math.PI / 32)];
      return middle.map((at, k) => at + radius * (c * right[k] + s * up[k]));
    });
  }

  grab(link, at) {
    const variable = link < 0 ? -1 : this.links[link].variable;
    if (!this.variables[variable]) return undefined;
    const point = this.#nearest_vertex(link, at);
    return (x, y) => this.#drag(variable, link, point, x, y);
  }

  // The link's vertex, in its own lattice, that appears nearest to a pixel.
  #nearest_vertex(link, [x, y]) {
    const { vertices } = this.meshes[link];
    let least = Infinity, best = [0, 0, 0];
    for (let v = 0; v < vertices.length; v += 3) {
      const vertex = vertices.subarray(v, v + 3);
      const [u, w] = this.view.pixel(placed(this.placed[link], vertex));
      const far = Math.hypot(u - x, w - y);
      if (far < least) [least, best] = [far, vertex];
    }
    return best;
  }

  // Moves a link's joint so that its point follows the pointer, as far as the joint allows.
  #drag(variable, link, point, x, y) {
    const pixel = () => this.view.pixel(placed(this.placed[link], point));
    const { lower, upper, slides } = this.variables[variable];
    const small = slides ? (upper - lower) / 1000 : 0.001;
    const value = this.values[variable];
    const before = pixel();
    this.values[variable] = value + (value + small > upper ? -small : small);
    this.#place();
    const way = pixel().map((after, i) => (after - before[i]) / (this.values[variable] - value));
    const squared = way[0] ** 2 + way[1] ** 2;
    // If the view is along its axis, the joint turns by the pointer's movement, not by the point's.
    const step = squared < 100 ? (x - y) / 150 : (x * way[0] + y * way[1]) / squared;
    this.set(this.values.with(variable, value + Math.min(Math.max(step, -0.3), 0.3)));
  }
}
