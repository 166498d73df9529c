// Shared by all pages: a canvas with meshes that mouse, touch and keyboard rotate, zoom and drag.

const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const bytes_of = text => Uint8Array.from(atob(text), character => character.charCodeAt(0));

// A new element with its properties and children.
const element = (name, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

// A slider and a number field for one value: calls `set(value)` with the reader's choice; `show(value)` displays it.
const slider = (name, lower, upper, [unit, long_unit, scale], digits, set) => {
  const range = element("input", { type: "range", min: lower, max: upper, step: "any" });
  const number = element("input", { type: "number", step: "any" });
  range.setAttribute("aria-label", name);
  number.setAttribute("aria-label", `${name}, ${long_unit}`);
  let shown;
  range.oninput = () => set(+range.value);
  number.onchange = () => {
    shown = undefined;
    set(+number.value / scale);
  };
  const row = element("label", {}, element("span", { textContent: name }), range, number, unit);
  const show = value => {
    if (value === shown) return;
    shown = value;
    range.value = value;
    number.value = +(value * scale).toFixed(digits);
  };
  return { row, range, number, show };
};
const DEGREES = ["\u00B0", "degrees", 180 / Math.PI];

const OWN_CODE = " Verdict, distance and points are worked out by flashbvh's own code, compiled for WebAssembly, from the " +
  "image that the firmware holds.";
const name_of = base64 => new TextDecoder().decode(bytes_of(base64));

// Subclasses define marks() and write(), and may override matrices(), colours(), grab() and key().
class Stage {
  #colours = {};
  #timer = 0;

  constructor(section, label) {
    this.section = section;
    this.says = element("p", { className: "says" });
    this.says.setAttribute("role", "status");
    this.canvas = element("canvas", { tabIndex: 0 });
    this.canvas.setAttribute("aria-label", label);
  }

  // Lays out the page's elements: `bar` (or null) below the canvas, the controls, and a note on their use.
  lay_out(bar, controls, note) {
    return element("div", { className: "stage" }, this.says, element("div", { className: "arm" },
      element("div", {}, this.canvas, ...bar ? [bar] : []), element("div", { className: "values" }, ...controls)),
    element("p", { className: "note", textContent: note }));
  }

  // `meshes`: as in View.
  open(meshes) {
    this.view = new View(this.canvas, meshes);
    this.#frame(meshes);
    this.#listen();
  }

  // The handler for drags that start at a pixel on a mesh, or on none; undefined: the drag turns the view.
  grab() {}
  // Returns true if it handled the key.
  key(event) {
    const way = KEYS[event.key];
    if (way) this.turn(0.1 * way[0], 0.1 * way[1]);
    else if (event.key === "+" || event.key === "-") this.#come(event.key === "+" ? 0.9 : 1.1);
    else return false;
    return true;
  }

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

  // The transformations and colours of the meshes: by default one mesh that does not move.
  matrices() {
    return [IDENTITY];
  }
  colours() {
    return [this.colour("--inner")];
  }

  // Fits the view to all meshes in their current positions.
  #frame(meshes) {
    const lower = [Infinity, Infinity, Infinity], upper = [-Infinity, -Infinity, -Infinity];
    const matrices = this.matrices();
    meshes.forEach(({ vertices }, mesh) => {
      for (let v = 0; v < vertices.length; v += 3) {
        const point = placed(matrices[mesh], vertices.subarray(v, v + 3));
        for (let i = 0; i < 3; ++i) {
          lower[i] = Math.min(lower[i], point[i]);
          upper[i] = Math.max(upper[i], point[i]);
        }
      }
    });
    this.view.middle = lower.map((least, i) => (least + upper[i]) / 2);
    this.view.size = Math.hypot(...lower.map((least, i) => upper[i] - least)) || 1;
  }

  draw() {
    if (this.drawing) return;
    this.drawing = requestAnimationFrame(() => {
      this.drawing = 0;
      this.view.draw(this.matrices(), this.colours(), this.colour("--ground"), this.marks());
    });
  }

  // A colour of the page, which differs in dark mode.
  colour(name) {
    const text = this.#colours[name] ||= getComputedStyle(this.section).getPropertyValue(name).trim()
      .replace(/^#(.)(.)(.)$/, "#$1$1$2$2$3$3");
    return [1, 3, 5].map(i => parseInt(text.slice(i, i + 2), 16) / 255).concat(1);
  }

  // Shows an answer: draws at once; calls write() at once if the verdict changed, else at most ten times per second,
  // because writing takes a quarter of a frame.
  answered(verdict) {
    if (!this.canvas.isConnected) return;
    if (this.section.dataset.verdict !== `${verdict}`) this.write();
    this.#timer ||= setTimeout(() => {
      this.#timer = 0;
      if (this.canvas.isConnected) this.write();
    }, 100);
    this.draw();
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
  }

  // Two fingers zoom.
  #listen() {
    const { canvas } = this;
    const held = new Map();
    const apart = () => Math.hypot(...[0, 1].map(i => [...held.values()].reduce((sum, at) => at[i] - sum, 0)));
    const at = event => [event.offsetX, event.offsetY];
    let drag;
    canvas.onpointerdown = event => {
      held.set(event.pointerId, at(event));
      drag = this.grab(this.view.pick(this.matrices(), ...at(event)), at(event), event) ||
        ((x, y) => this.turn(x / 150, y / 150));
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
      event.preventDefault();
      this.#come(1 + event.deltaY / 1000);
    };
    canvas.onkeydown = event => { if (this.key(event)) event.preventDefault(); };
    new ResizeObserver(() => this.draw()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.#colours = {};
      this.draw();
    });
  }
}

// Elements with this data attribute show their value when clicked or chosen by keyboard.
const offer = (section, name, set) => {
  for (const place of document.querySelectorAll(`[data-${name}]`)) {
    const show = () => {
      set(place.dataset[name], place.dataset);
      section.scrollIntoView({ behavior: "smooth", block: "nearest" });
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
};

// Once the page is loaded: runs `make(section, data)`, or shows the error.
const begin = (id, make) => addEventListener("DOMContentLoaded", async () => {
  const section = document.getElementById(id);
  section.hidden = false;
  try {
    await make(section, JSON.parse(document.getElementById(`${id}-data`).textContent));
  } catch (error) {
    section.append(element("p", { className: "note", textContent: `It cannot be shown here: ${error.message}.` }));
  }
});

// A choice of one of several: `make(i)` builds its view.
const choose = (section, names, first, make) => {
  const choice = element("select", { onchange: () => show(+choice.value) },
    ...names.map((textContent, value) => element("option", { value, textContent })));
  choice.setAttribute("aria-label", "What is shown");
  const place = element("div");
  section.append(...names.length > 1 ? [choice] : [], place);
  let stage;
  const show = i => {
    if (stage) stage.view.close();
    choice.value = i;
    stage = make(i);
    place.replaceChildren(stage.box);
    stage.show();
  };
  show(first);
  return show;
};

// The library's exports.
const library_of = async text => (await WebAssembly.instantiate(bytes_of(text))).instance.exports;

// An image's bytes in the library's memory; `open` then opens it.
const put = (library, image, open) => {
  const place = library.room(image.length);
  new Uint8Array(library.memory.buffer).set(image, place);
  const status = open(image.length);
  if (status !== 0) throw new Error(`the image is refused, status ${status}`);
};

// Copies of a mesh's arrays.
const arrays_of = (library, mesh) => ({
  vertices: new Int16Array(library.memory.buffer, library.vertices(mesh), 3 * library.vertex_count(mesh)).slice(),
  triangles: new Uint16Array(library.memory.buffer, library.triangles(mesh), 3 * library.triangle_count(mesh)).slice() });
