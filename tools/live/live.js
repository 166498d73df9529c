// The section of the page: the robot, a slider for each value, the distances, what the guard says.

const KEYS = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };

// What of the page belongs to it. `trajectory`: a Trajectory, or nothing.
class Live {
  constructor(section, arm, trajectory) {
    this.arm = arm;
    this.trajectory = trajectory;
    this.section = section;
    this.says = element("p", { className: "says" });
    this.says.setAttribute("role", "status");
    this.canvas = element("canvas", { tabIndex: 0 });
    this.canvas.setAttribute("aria-label", "The robot. Arrow keys turn it, plus and minus come nearer and go away.");
    this.sliders = arm.variables.map((variable, i) => this.#slider(variable, i));
    const robot = trajectory ? element("div", {}, this.canvas, trajectory.bar) : this.canvas;
    section.append(this.says, element("div", { className: "arm" }, robot,
      element("div", { className: "values" }, ...this.sliders.map(slider => slider.row), this.#distances())),
      element("p", { className: "note", textContent: "Drag a link to move its joint, the ground to turn the robot. " +
        "Verdict, distance and points are worked out by flashbvh's own code, compiled for WebAssembly, from the image " +
        "that the firmware holds." }));
    this.view = new View(this.canvas, arm.links.map((_, i) => arm.mesh(i)));
    this.#frame();
    this.#listen();
    this.update();
    if (trajectory) trajectory.attach(this);
  }

  #slider(variable, i) {
    const unit = variable.slides ? ["m", 1] : ["\u00B0", 180 / Math.PI];
    const range = element("input", { type: "range", min: variable.lower, max: variable.upper, step: "any" });
    const number = element("input", { type: "number", step: "any", min: variable.lower * unit[1], max: variable.upper * unit[1] });
    range.setAttribute("aria-label", variable.name);
    number.setAttribute("aria-label", `${variable.name}, ${variable.slides ? "metres" : "degrees"}`);
    range.oninput = () => this.set(i, +range.value);
    number.onchange = () => this.set(i, +number.value / unit[1]);
    const row = element("label", {}, element("span", { textContent: variable.name }), range, number, unit[0]);
    return { row, range, number, scale: unit[1] };
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
    this.sliders.forEach(({ range, number, scale }, i) => {
      range.value = this.arm.values[i];
      number.value = +(this.arm.values[i] * scale).toFixed(2);
    });
    this.#say();
    this.draw();
  }

  #say() {
    const { verdict, links, nearest } = this.answer;
    const names = two => two.map(i => this.arm.links[i].name).join(" \u2013 ");
    const square = element("span", { className: `key v${verdict}` });
    const where = links && verdict !== 0 ? `: ${names(links)}` : "";
    const least = nearest ? `. Nearest: ${(1000 * nearest.metres).toFixed(1)} mm, ${names(nearest.links)}` : "";
    const more = this.arm.stop > this.arm.baked_stop ? ". Pairs that never come within " +
      `${+(1000 * this.arm.baked_stop).toPrecision(3)} mm are not looked at` : "";
    this.says.replaceChildren(square, element("b", { textContent: VERDICTS[verdict] }), where + least + more);
    this.section.dataset.verdict = verdict;
  }

  // The robot as it stands, whole.
  #frame() {
    const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
    this.arm.links.forEach((_, link) => {
      const { vertices } = this.arm.mesh(link);
      for (let v = 0; v < vertices.length; v += 3) {
        const point = placed(this.arm.matrices[link], vertices.subarray(v, v + 3));
        for (let i = 0; i < 3; ++i) {
          lower[i] = Math.min(lower[i], point[i]);
          upper[i] = Math.max(upper[i], point[i]);
        }
      }
    });
    this.view.middle = lower.map((least, i) => (least + upper[i]) / 2);
    this.view.size = Math.hypot(...lower.map((least, i) => upper[i] - least));
  }

  draw() {
    if (this.drawing) return;
    this.drawing = requestAnimationFrame(() => {
      this.drawing = 0;
      this.view.draw(this.arm.matrices, this.#colours(), this.#colour("--ground"),
        this.answer.nearest && this.answer.nearest.line, this.#colour("--text"));
    });
  }

  #colour(name) {
    const text = getComputedStyle(this.section).getPropertyValue(name).trim().replace(/^#(.)(.)(.)$/, "#$1$1$2$2$3$3");
    return [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255).concat(1);
  }
  #colours() {
    const lit = this.answer.verdict !== 0 && this.answer.links || [];
    const plain = [this.#colour("--inner"), this.#colour("--leaf")];
    return this.arm.links.map((_, i) => lit.includes(i) ? this.#colour(`--v${this.answer.verdict}`) : plain[i % 2]);
  }

  #listen() {
    const { canvas, view } = this;
    const at = event => [event.offsetX, event.offsetY];
    canvas.onpointerdown = event => {
      canvas.setPointerCapture(event.pointerId);
      const link = view.pick(this.arm.matrices, ...at(event));
      this.draw();
      this.held = { variable: link < 0 ? undefined : this.arm.links[link].variable, link, at: at(event) };
      if (this.held.variable === 255) this.held.variable = undefined;
      this.held.point = this.held.variable === undefined ? null : this.#nearest_vertex(link, at(event));
    };
    canvas.onpointermove = event => {
      if (!this.held) return;
      const [x, y] = at(event), [u, v] = this.held.at;
      this.held.at = [x, y];
      this.held.variable === undefined ? this.#turn((x - u) / 150, (y - v) / 150) : this.#drag(x - u, y - v);
    };
    canvas.onpointerup = canvas.onpointercancel = () => { this.held = null; };
    canvas.onwheel = event => {
      event.preventDefault();
      this.#come(event.deltaY / 1000);
    };
    canvas.onkeydown = event => {
      if (KEYS[event.key]) this.#turn(...KEYS[event.key]);
      else if (event.key === "+" || event.key === "-") this.#come(event.key === "+" ? -0.1 : 0.1);
      else return;
      event.preventDefault();
    };
    new ResizeObserver(() => this.draw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").onchange = () => this.draw();
    this.#offer("values", text => this.set_all(text.split(" ").map(Number)));
    if (this.trajectory) this.#offer("period", text => this.trajectory.go(+text));
  }

  #turn(yaw, pitch) {
    const { turn } = this.view;
    turn.yaw -= yaw;
    turn.pitch = Math.min(Math.max(turn.pitch + pitch, -1.5), 1.5);
    this.draw();
  }
  #come(by) {
    this.view.distance = Math.min(Math.max(this.view.distance * (1 + by), 0.5), 20);
    this.draw();
  }

  // In the link's own lattice: the vertex that is seen nearest to a pixel.
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

  // Moves the held link's joint so that its point follows the pointer, along the way that it can.
  #drag(x, y) {
    const { variable, link, point } = this.held;
    const pixel = () => this.view.pixel(placed(this.arm.matrices[link], point));
    const { lower, upper, slides } = this.arm.variables[variable];
    const small = slides ? (upper - lower) / 1000 : 0.001;
    const value = this.arm.values[variable];
    const before = pixel();
    this.arm.values[variable] = value + (value + small > upper ? -small : small);
    this.arm.place();
    const way = pixel().map((after, i) => (after - before[i]) / (this.arm.values[variable] - value));
    const squared = way[0] ** 2 + way[1] ** 2;
    // Seen from its end a joint turns by the pointer's way, not by the point's.
    const step = squared < 100 ? (x - y) / 150 : (x * way[0] + y * way[1]) / squared;
    this.set(variable, value + Math.min(Math.max(step, -0.3), 0.3));
  }

  // What has this in its data shows it, by mouse and by keyboard.
  #offer(name, set) {
    for (const place of document.querySelectorAll(`[data-${name}]`)) {
      const show = () => {
        set(place.dataset[name]);
        this.section.scrollIntoView({ behavior: "smooth", block: "nearest" });
      };
      place.tabIndex = 0;
      place.setAttribute("role", "button");
      place.onclick = show;
      place.onkeydown = event => {
        if (event.key === "Enter" || event.key === " ") {
          event.preventDefault();
          show();
        }
      };
    }
  }
}

const start = async () => {
  const section = document.getElementById("live");
  const data = JSON.parse(document.getElementById("live-data").textContent);
  section.hidden = false;
  try {
    window.live = new Live(section, await Arm.from(data), data.names && new Trajectory(data));
  } catch (error) {
    section.append(element("p", { className: "note", textContent: `The robot cannot be shown here: ${error.message}.` }));
  }
};
addEventListener("DOMContentLoaded", start);
