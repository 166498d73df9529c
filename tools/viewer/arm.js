// An interactive robot with firmware's library (arm.cpp). live_section.cpp writes `data`.

const VERDICTS = ["free", "warn", "not yet known", "stops", "refused"];

// flashbvh's answers about one robot. Numbers are radians and metres.
class Arm {
  static async from({ library, image, zones }) {
    return new Arm(await library_of(library), bytes_of(image), zones);
  }

  // `zones`: for each a joint, a point in cells of its frame, and a radius in metres.
  constructor(library, image, zones) {
    this.library = library;
    put(library, image, bytes => library.open(bytes));
    const each = (count, make) => Array.from({ length: count }, (_, i) => make(i));
    this.variables = each(library.variable_count(), i => ({
      name: this.#text(library.variable_name(i)), slides: library.is_slide(i) !== 0,
      lower: library.lower(i), upper: library.upper(i) }));
    this.links = each(library.link_count(), i => ({
      name: this.#text(library.name_of_link(i)), variable: library.variable_of_link(i) }));
    this.pairs = each(library.pair_count(), i => [library.first_of_pair(i), library.second_of_pair(i)]);
    // A part of a link, used near a joint, has the link's name and a higher index.
    this.links.forEach(link => { link.whole = this.links.findIndex(({ name }) => name === link.name); });
    this.stop = Math.max(0, ...this.pairs.map((_, i) => library.stop_of(i)));
    this.warn = Math.max(0, ...this.pairs.map((_, i) => library.warn_of(i)));
    this.baked_stop = this.stop;
    this.zones = zones;
    this.values = this.variables.map(({ lower, upper }) => Math.min(Math.max(0, lower), upper));
    this.place();
  }

  #text(place) {
    const memory = new Uint8Array(this.library.memory.buffer);
    return new TextDecoder().decode(memory.subarray(place, memory.indexOf(0, place)));
  }

  // A link's mesh; empty for a part.
  mesh(link) {
    return this.links[link].whole === link ? arrays_of(this.library, link) :
      { vertices: new Int16Array(), triangles: new Uint16Array() };
  }

  place() {
    this.values.forEach((value, i) => this.library.set_value(i, value));
    this.library.place();
    const matrix = at => new Float32Array(new Float64Array(this.library.memory.buffer, at, 16));
    this.matrices = this.links.map((_, i) => matrix(this.library.matrix_of(i)));
    this.balls = this.zones.map(([joint, x, y, z, radius]) => (
      { middle: placed(matrix(this.library.matrix_of_joint(joint)), [x, y, z]).slice(0, 3), radius }));
  }

  // The verdict, and the nearest of all guarded pairs: metres, two points, two links; or null.
  answer() {
    const verdict = this.library.verdict();
    const pair = this.library.pair_of_answer();
    const place = this.library.measure();
    const [metres, ...points] = place ? new Float64Array(this.library.memory.buffer, place, 7) : [];
    const of = place ? new Uint32Array(this.library.memory.buffer, place + 56, 1)[0] : 0;
    const links = i => this.pairs[i] && this.pairs[i].map(link => this.links[link].whole);
    return { verdict, links: links(pair),
      nearest: place ? { metres, line: [points.slice(0, 3), points.slice(3)], links: links(of) } : null };
  }
}
