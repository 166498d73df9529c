// Shared by all drawings: a canvas with meshes that mouse, touch and keyboard turn, zoom and drag, beside sliders.

const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const OWN_CODE = " A click or tap chooses the model: then a finger turns it, wheel or two fingers zoom. The answers are those " +
  "of the firmware's own code from its image.";

const bytes_of = text => Uint8Array.from(atob(text), character => character.charCodeAt(0));

// A new element with its properties and children.
const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

// A slider and a number field for one value: calls `set(value)` with the reader's choice; `show(value)` displays it.
const slider = (name, lower, upper, [unit, long_unit, scale], digits, set) => {
  const range = element("input", { type: "range", min: lower, max: upper, step: "any", oninput: () => set(+range.value) });
  const number = element("input", { type: "number", step: "any", onchange: () => set(+number.value / scale) });
  range.setAttribute("aria-label", name);
  number.setAttribute("aria-label", `${name}, ${long_unit}`);
  const row = element("label", {}, element("span", { textContent: name }), range, number, unit);
  const show = value => {
    range.value = value;
    number.value = +(value * scale).toFixed(digits);
  };
  return { row, range, number, show };
};
const DEGREES = ["\u00B0", "degrees", 180 / Math.PI];

// An image's bytes in the library's memory; `open` then opens it.
const put = (library, image, open) => {
  const bytes = bytes_of(image);
  const place = library.room(bytes.length);  // may replace the buffer
  new Uint8Array(library.memory.buffer).set(bytes, place);
  const status = open(bytes.length);
  if (status !== 0) throw new Error(`the image is refused, status ${status}`);
};

// Copies of numbers in the library's memory.
const words_at = (library, place, count) => [...new Int32Array(library.memory.buffer, place, count)];
const doubles_at = (library, place, count) => [...new Float64Array(library.memory.buffer, place, count)];
const arrays_of = (library, mesh) => ({
  vertices: new Int16Array(library.memory.buffer, library.vertices(mesh), 3 * library.vertex_count(mesh)).slice(),
  triangles: new Uint16Array(library.memory.buffer, library.triangles(mesh), 3 * library.triangle_count(mesh)).slice() });

// Subclasses define matrices(), colours() and marks(), and may override grab() and define free_pose(), for set().
class Stage {
  // `controls`: elements beside the canvas; `note`: on their use.
  constructor(section, label, meshes, controls, note, trajectory) {
    this.section = section;
    this.trajectory = trajectory;
    this.says = element("p", { className: "says" });
    this.says.setAttribute("role", "status");
    this.canvas = element("canvas", { tabIndex: 0 });
    this.canvas.setAttribute("aria-label", `${label}. Arrow keys turn the view, plus and minus come nearer and go away.`);
    this.meshes = meshes;
    const button = (textContent, onclick) => element("button", { textContent, onclick });
    const buttons = element("p", { className: "buttons" }, button("First view", () => this.#first()),
      ...this.free_pose ? [button("Free pose", () => this.set(this.free_pose() || this.pose || this.values))] : []);
    this.box = element("div", { className: "stage" }, this.says, element("div", { className: "arm" },
      element("div", {}, this.canvas, ...trajectory ? [trajectory.bar] : [], buttons), element("div", { className: "values" }, ...controls)),
    element("p", { className: "note", textContent: note + OWN_CODE }));
  }

  // Once the box is in the page.
  begin() {
    this.view = new View(this.canvas, this.meshes);
    if (this.trajectory) this.trajectory.attach(this.section);
    this.#first();
    this.#listen();
  }

  // The handler for drags that start at a pixel on a mesh, or on none; undefined: the drag turns the view.
  grab() {}

  turn(yaw, pitch) {
    const { turn } = this.view;
    turn.yaw -= yaw;
    turn.pitch = Math.min(Math.max(turn.pitch + pitch, -1.5), 1.5);
    this.draw();
  }
  #come(times) {
    this.view.distance = Math.min(Math.max(this.view.distance * times, 0.1), 20);
    this.draw();
  }

  // The view from where the page begins, fitted to all meshes in their current positions.
  #first() {
    const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
    const matrices = this.matrices();
    this.meshes.forEach(({ vertices }, mesh) => {
      for (let v = 0; v < vertices.length; v += 3) {
        const point = placed(matrices[mesh], vertices.subarray(v, v + 3));
        for (let i = 0; i < 3; ++i) {
          lower[i] = Math.min(lower[i], point[i]);
          upper[i] = Math.max(upper[i], point[i]);
        }
      }
    });
    this.view.look(lower.map((least, i) => (least + upper[i]) / 2), Math.hypot(...lower.map((least, i) => upper[i] - least)) || 1);
    this.draw();
  }

  draw() {
    if (!this.view || this.drawing) return;
    this.drawing = requestAnimationFrame(() => {
      this.drawing = 0;
      this.view.draw(this.matrices(), this.colours(), this.colour("--ground"), this.marks());
    });
  }

  // A colour of the page, which differs in dark mode.
  colour(name) {
    const text = getComputedStyle(this.section).getPropertyValue(name).trim().replace(/^#(.)(.)(.)$/, "#$1$1$2$2$3$3");
    return [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255).concat(1);
  }

  // The view's axes in the base's frame: right, up, towards the viewer.
  axes() {
    const eye = this.view.eye();
    return [0, 1, 2].map(i => [eye[i], eye[4 + i], eye[8 + i]]);
  }

  // A line between two points of the base's frame, and its end points.
  line(points) {
    return ["LINES", "POINTS"].map(kind => ({ kind, points, colour: this.colour("--text") }));
  }

  // Shows a verdict's colour, its text, and details.
  say(verdict, what, more) {
    this.says.replaceChildren(element("span", { className: `key v${verdict}` }), element("b", { textContent: what }), more);
    this.section.dataset.verdict = verdict;
    this.draw();
  }

  // Until it has the focus, swipes and the wheel scroll the page. Two fingers zoom.
  #listen() {
    const { canvas } = this;
    const held = new Map();
    const apart = () => Math.hypot(...[0, 1].map(i => [...held.values()].reduce((sum, at) => at[i] - sum, 0)));
    const at = event => [event.offsetX, event.offsetY];
    let drag;
    const is_chosen = () => document.activeElement === canvas;
    canvas.onclick = () => canvas.focus({ preventScroll: true });
    canvas.onpointerdown = event => {
      if (event.pointerType === "touch" && !is_chosen()) return;
      held.set(event.pointerId, at(event));
      drag = this.grab(this.view.pick(this.matrices(), ...at(event)), at(event)) || ((x, y) => this.turn(x / 150, y / 150));
      this.draw();
      canvas.setPointerCapture(event.pointerId);
    };
    canvas.onpointermove = event => {
      if (!held.has(event.pointerId)) return;
      const before = apart(), [x, y] = at(event), [u, v] = held.get(event.pointerId);
      held.set(event.pointerId, [x, y]);
      held.size > 1 ? this.#come(before / (apart() || 1)) : drag(x - u, y - v);
    };
    canvas.onpointerup = canvas.onpointercancel = event => held.delete(event.pointerId);
    canvas.onwheel = event => {
      if (!is_chosen()) return;
      event.preventDefault();
      this.#come(1 + event.deltaY / 1000);
    };
    canvas.onkeydown = event => {
      const way = KEYS[event.key];
      if (way) this.turn(0.1 * way[0], 0.1 * way[1]);
      else if (event.key === "+" || event.key === "-") this.#come(event.key === "+" ? 0.9 : 1.1);
      else return;
      event.preventDefault();
    };
    new ResizeObserver(() => this.draw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
  }
}
