// A source mesh and its baked mesh: faces and lines, and the point of the largest deviation.

class DeviationStage extends Stage {
  constructor(section, { name, original, coarse, most, text }) {
    super(section, "The file's mesh, and the baked one as lines. Arrow keys turn them, plus and minus come nearer and go away.");
    const halves = base64 => new Int16Array(bytes_of(base64).buffer);
    Object.assign(this, { name: name_of(name), most, text, coarse: halves(coarse), original: halves(original) });
    const near = element("button", { textContent: "The largest deviation from near", onclick: () => this.#go_near() });
    this.box = this.lay_out(null, [near], "Faces: the file's mesh, at most the 1,500 triangles that are nearest to the largest " +
      "deviation; lines: what is baked. Drag to turn them.");
  }

  show() {
    this.open([{ vertices: this.original, triangles: Uint16Array.from({ length: this.original.length / 3 }, (_, i) => i) }]);
    this.say(0, this.name, `: at most ${this.text} from what is baked of it, at the point`);
    this.draw();
  }

  #go_near() {
    Object.assign(this.view, { middle: [0, 0, 0], size: Math.max(24 * this.most, 1), distance: 1.25 });
    this.draw();
  }

  // Draws the edges of triangles that face the viewer.
  marks() {
    const eye = this.view.eye();
    const points = [];
    for (let at = 0; at < this.coarse.length; at += 9) {
      const [p, q, r] = [0, 3, 6].map(i => [...this.coarse.subarray(at + i, at + i + 3)]);
      const [u, v, w] = [p, q, r].map(corner => placed(eye, corner));
      const faces = (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]);
      if (faces > 0) points.push(p, q, q, r, r, p);
    }
    return [{ kind: "LINES", points, colour: this.colour("--leaf") }, { kind: "POINTS", points: [[0, 0, 0]], colour: this.colour("--v3") }];
  }
}

begin("deviation", (section, { meshes }) => {
  choose(section, meshes.map(({ name }) => name_of(name)), 0, i => {
    window.deviation = new DeviationStage(section, meshes[i]);
    return window.deviation;
  });
});
