// The page's section: the robot, a slider for each value, the distances, the guard's verdict.

class Live extends Stage {
  // `data`: from the page; with `names` it has a trajectory.
  constructor(section, arm, data) {
    super(section, "The robot. Arrow keys turn it, plus and minus come nearer and go away.");
    this.arm = arm;
    this.trajectory = data.names && this.#trajectory(data);
    this.points = element("p", { className: "note" });
    this.sliders = arm.variables.map(({ name, lower, upper, slides }, i) =>
      slider(name, lower, upper, slides ? ["m", "metres", 1] : DEGREES, 2, value => this.set(i, value)));
    section.append(this.lay_out(this.trajectory && this.trajectory.bar,
      [...this.sliders.map(({ row }) => row), this.#distances(), this.points],
      "Drag a link to move its joint, the ground to turn the robot." +
      (arm.zones.length > 0 ? " Dashed: joint zones, in which neighbours may touch and no guard looks." : "") + OWN_CODE));
    this.open(arm.links.map((_, i) => arm.mesh(i)));
    offer(section, "values", text => this.set_all(text.split(" ").map(Number)));
    this.update();
    if (!this.trajectory) return;
    offer(section, "period", text => this.trajectory.go(+text));
    this.trajectory.attach(section);
  }

  #trajectory({ values, verdicts, names }) {
    const numbers = new Float32Array(bytes_of(values).buffer);
    const count = this.arm.variables.length;
    return new Trajectory(verdicts, "Period", period => {
      this.set_all([...numbers.slice(count * period, count * (period + 1))]);
      return `${names[period]}: ${VERDICTS[verdicts[period]]} on the way`;
    });
  }

  #distances() {
    const inputs = ["stop", "warn"].map(name => {
      const input = element("input", { type: "number", min: 0, step: 1, value: +(1000 * this.arm[name]).toPrecision(3) });
      input.onchange = () => {
        this.arm[name] = Math.max(0, +input.value) / 1000;
        this.arm.library.set_distances(this.arm.stop, this.arm.warn);
        this.update();
      };
      return element("label", {}, element("span", { textContent: name }), input, "mm");
    });
    return element("div", { className: "distances" }, ...inputs);
  }

  set(variable, value) {
    const { lower, upper } = this.arm.variables[variable];
    this.arm.values[variable] = Math.min(Math.max(value, lower), upper);
    this.update();
  }
  set_all(values) {
    this.arm.values = values.slice(0, this.arm.variables.length);
    this.update();
  }

  update() {
    this.arm.place();
    this.answer = this.arm.answer();
    this.answered(this.answer.verdict);
  }

  write() {
    const { verdict, links, nearest } = this.answer;
    const names = two => two.map(i => this.arm.links[i].name).join(" \u2013 ");
    const where = links && verdict !== 0 ? `: ${names(links)}` : "";
    const least = nearest ? `${where ? ". Nearest" : ""}: ${names(nearest.links)}, ${(1000 * nearest.metres).toFixed(1)} mm apart` : "";
    const more = this.arm.stop > this.arm.baked_stop ? ". Pairs that never come within " +
      `${+(1000 * this.arm.baked_stop).toPrecision(3)} mm are not looked at` : "";
    this.say(verdict, VERDICTS[verdict], where + least + more);
    const points = nearest ? nearest.line.map(point => `(${point.map(part => part.toFixed(4)).join(", ")})`) : [];
    this.points.textContent = points.length > 0 ? `The nearest points, in m of the base's frame: ${points.join(" and ")}` : "";
    this.sliders.forEach(({ show }, i) => show(this.arm.values[i]));
  }

  matrices() {
    return this.arm.matrices;
  }
  colours() {
    const lit = this.answer.verdict !== 0 && this.answer.links || [];
    const plain = [this.colour("--inner"), this.colour("--leaf")];
    return this.arm.links.map((_, i) => lit.includes(i) ? this.colour(`--v${this.answer.verdict}`) : plain[i % 2]);
  }
  marks() {
    const zones = this.arm.balls.map(ball => ({ kind: "LINES", points: this.#dashes(ball), colour: this.colour("--accent") }));
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
    const variable = link < 0 ? 255 : this.arm.links[link].variable;
    if (variable === 255) return undefined;
    const point = this.#nearest_vertex(link, at);
    return (x, y) => this.#drag(variable, link, point, x, y);
  }

  // The link's vertex, in its own lattice, that appears nearest to a pixel.
  #nearest_vertex(link, [x, y]) {
    const { vertices } = this.arm.mesh(link);
    let least = Infinity, best = [0, 0, 0];
    for (let v = 0; v < vertices.length; v += 3) {
      const vertex = vertices.subarray(v, v + 3);
      const [u, w] = this.view.pixel(placed(this.arm.matrices[link], vertex));
      const far = Math.hypot(u - x, w - y);
      if (far < least) [least, best] = [far, vertex];
    }
    return best;
  }

  // Moves a link's joint so that its point follows the pointer, as far as the joint allows.
  #drag(variable, link, point, x, y) {
    const pixel = () => this.view.pixel(placed(this.arm.matrices[link], point));
    const { lower, upper, slides } = this.arm.variables[variable];
    const small = slides ? (upper - lower) / 1000 : 0.001;
    const value = this.arm.values[variable];
    const before = pixel();
    this.arm.values[variable] = value + (value + small > upper ? -small : small);
    this.arm.place();
    const way = pixel().map((after, i) => (after - before[i]) / (this.arm.values[variable] - value));
    const squared = way[0] ** 2 + way[1] ** 2;
    // If the view is along its axis, the joint turns by the pointer's movement, not by the point's.
    const step = squared < 100 ? (x - y) / 150 : (x * way[0] + y * way[1]) / squared;
    this.set(variable, value + Math.min(Math.max(step, -0.3), 0.3));
  }
}

begin("live", async (section, data) => { window.live = new Live(section, await Arm.from(data), data); });
