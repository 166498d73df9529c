// One mesh of a page: a ray through the point that the reader clicks, and marks of defects.

class RayStage extends Stage {
  constructor(section, meshes, { a }) {
    super(section, "The mesh. Arrow keys turn it, plus and minus come nearer and go away, Enter sends a ray through the middle.");
    const { name, origin, cell, unit, vertices, triangles, marks: odd } = meshes.all[a];
    Object.assign(this, { meshes, mesh: a, name, origin, cell, unit, vertices, triangles, odd });
    this.field = numbers_field("the ray from point to point, a line of --rays", 6, numbers => {
      this.cast(...[0, 3].map(from => this.origin.map((at, i) => numbers[from + i] / this.cell - at)));
    });
    this.box = this.lay_out(null, [this.field.row], "Click the mesh: a ray goes where you look. Drag to turn it." + OWN_CODE);
  }

  show() {
    this.open([this.meshes.all[this.mesh]]);
    this.say(0, this.name, `: ${this.triangles.length / 3} triangles; click one, and a ray says which it hits`);
    this.draw();
  }

  // The ray ends as far behind the view's centre as it starts in front of it.
  #cast_at(x, y) {
    const { from, way } = this.view.ray(x, y);
    const { middle, size } = this.view;
    const deep = way.reduce((sum, part, i) => sum + part * (middle[i] - from[i]), 0);
    this.cast(...[deep - size, deep + size].map(along => from.map((part, i) => part + along * way[i])));
  }
  cast(from, to) {
    const { ends, hit } = this.meshes.cast(this.mesh, from, to);
    this.hit = hit;
    this.ends = ends;
    this.field.text.value = ends.flat().map(part => +(part * this.cell).toPrecision(14)).join(" ");
    const side = ["its back", "edge on", "its front"][hit.side + 1];
    this.say(0, hit ? `The ray hits triangle ${hit.triangle}` : "The ray hits nothing", hit ? `, ${side}, ` +
      `${this.meshes.length(this.mesh, hit.distance)} from the ray's start, at (${hit.place.map(part => +part.toPrecision(5)).join(", ")})${this.unit}` : "");
    this.draw();
  }

  marks() {
    const { origin, vertices } = this;
    const odd = this.odd.map(([colour, places]) => ({ kind: "LINES", colour: this.colour(colour),
      points: places.map(v => [...vertices.subarray(3 * v, 3 * v + 3)]) }));
    if (!this.hit) return odd;
    const start = this.ends[0].map((part, i) => part - origin[i]);
    return [...odd, { kind: "TRIANGLES", points: this.hit.corners, colour: this.colour("--v3") }, ...this.line([start, this.hit.point])];
  }

  grab(mesh, at) {
    if (mesh === 0) this.#cast_at(...at);
  }
  key(event) {
    if (event.key !== "Enter") return super.key(event);
    this.#cast_at(this.canvas.clientWidth / 2, this.canvas.clientHeight / 2);
    return true;
  }
}
