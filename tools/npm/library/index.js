// Queries of baked meshes and robots: flashbvh's C interface (flashbvh/*.h) as WebAssembly, in batches of typed arrays.
// index.d.ts says what each takes and returns.

const module_url = new URL("flashbvh.wasm", import.meta.url);
const read_module = async () => {
  if (module_url.protocol === "file:") return (await import("node:fs")).readFileSync(module_url);
  const answer = await fetch(module_url);
  if (!answer.ok) throw new Error(`flashbvh: ${module_url} can't be fetched: ${answer.status}`);
  return answer.arrayBuffer();
};
const library = (await WebAssembly.instantiate(await read_module())).instance.exports;

const view = (Type, place, length) => new Type(library.memory.buffer, place, length);
const text_at = place => {
  const bytes = view(Uint8Array, place);
  return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
};
const [MESH_BYTES, POSE_BYTES, ROBOT_BYTES, GUARD_BYTES] = view(Uint32Array, library.sizes(), 4);

// Memory of the library, in blocks of a power of two: those that were freed, by its exponent.
const freed = Array.from({ length: 32 }, () => []);
const sizes = new Map();
let end = library.__heap_base.value;
const take = bytes => {
  const exponent = Math.max(3, 32 - Math.clz32(bytes - 1));
  let place = freed[exponent].pop();
  if (place === undefined) {
    place = Math.ceil(end / 8) * 8;
    const pages = Math.ceil((place + 2 ** exponent - library.memory.buffer.byteLength) / 65536);
    if (pages > 0) library.memory.grow(pages);
    end = place + 2 ** exponent;
  }
  sizes.set(place, exponent);
  return place;
};
const give = place => freed[sizes.get(place)].push(place);

// What an object holds is freed some time after the object is dropped.
const dropped = new FinalizationRegistry(places => places.forEach(give));
const keep = (object, ...places) => {
  dropped.register(object, places);
  return places;
};

const status_name = status => text_at(library.flashbvh_status_name(status));
const refuse = (status, where) => {
  const name = status_name(status);
  throw Object.assign(new Error(`flashbvh: ${name}${where}`), { status: name });
};
const need = (object, Type, name) => {
  if (!(object instanceof Type)) throw new TypeError(`flashbvh: ${name} is no ${Type.name}`);
  return object;
};

const copy_in = (Type, numbers) => {
  const place = take(Math.max(1, numbers.length * Type.BYTES_PER_ELEMENT));
  view(Type, place, numbers.length).set(numbers);
  return place;
};
const image_in = bytes => {
  if (bytes instanceof ArrayBuffer) bytes = new Uint8Array(bytes);
  return [copy_in(Uint8Array, need(bytes, Uint8Array, "an image")), bytes.length];
};
// Rows of so many numbers; other arrays of numbers become floats. Integers are not rounded for the caller.
const rows = (Type, numbers, width, name) => {
  if (Type === Float32Array && (Array.isArray(numbers) || numbers instanceof Float64Array)) {
    numbers = Float32Array.from(numbers);
  }
  need(numbers, Type, name);
  if (numbers.length % width !== 0) {
    throw new RangeError(`flashbvh: ${name} has ${numbers.length} numbers, no multiple of ${width}`);
  }
  return { count: numbers.length / width, place: copy_in(Type, numbers) };
};
// Arrays [Type, width] of `count` rows each, which call(...places) fills; it returns how many rows it answered.
const filled = (count, name, arrays, call) => {
  const places = arrays.map(([Type, width]) => take(Math.max(1, count * width * Type.BYTES_PER_ELEMENT)));
  try {
    arrays.forEach(([Type, width], i) => view(Type, places[i], count * width).fill(0));
    const answered = call(...places);
    if (answered < count) refuse(library.last_status(), `: ${name} ${answered}`);
    return arrays.map(([Type, width], i) => view(Type, places[i], count * width).slice());
  } finally {
    places.forEach(give);
  }
};
// The same of rows that are copied in: call(count, place, ...places).
const answered = (Type, numbers, width, name, arrays, call) => {
  const { count, place } = rows(Type, numbers, width, `${name}s`);
  try {
    return filled(count, name, arrays, (...places) => call(count, place, ...places));
  } finally {
    give(place);
  }
};

const UNITS = ["", "nm", "um", "mm", "cm", "m", "mil", "in", "ft"];

export class Mesh {
  constructor(bytes) {
    const [image, length] = image_in(bytes);
    [this.place] = keep(this, take(MESH_BYTES), image);
    const status = library.flashbvh_open(image, length, this.place);
    if (status !== 0) refuse(status, "");
    this.cell = library.cell(this.place);
    this.fine = this.cell / 256;
    this.unit = UNITS[library.flashbvh_mesh_unit(this.place)];
    this.triangleCount = library.flashbvh_mesh_triangles(this.place);
    this.isClosed = library.flashbvh_mesh_is_closed(this.place) !== 0;
  }
}

export class Poses {
  static fromMatrices(mesh, numbers) {
    return new Poses(mesh, numbers, 12, library.poses_of_matrices);
  }
  static fromQuaternions(mesh, numbers) {
    return new Poses(mesh, numbers, 7, library.poses_of_quaternions);
  }
  constructor(mesh, numbers, width, make) {
    need(mesh, Mesh, "mesh");
    answered(Float32Array, numbers, width, "pose", [], (count, place) => {
      this.length = count;
      [this.place] = keep(this, take(Math.max(1, count * POSE_BYTES)));
      return make(mesh.place, count, place, this.place);
    });
  }
}

// Of B at each pose in A's frame: call(a, b, poses, count, ...places).
const posed = (a, b, poses, arrays, call) => {
  need(a, Mesh, "a"), need(b, Mesh, "b"), need(poses, Poses, "poses");
  return filled(poses.length, "pose", arrays, (...places) => call(a.place, b.place, poses.place, poses.length, ...places));
};

export const intersects = (a, b, poses) => posed(a, b, poses, [[Uint8Array, 1]], library.intersects)[0];

export const solidsIntersect = (a, b, poses) => posed(a, b, poses, [[Uint8Array, 1]], library.solids_intersect)[0];

export const closerThan = (a, b, poses, distance) => {
  if (!(Number.isInteger(distance) && distance >= 0 && distance <= 0xffffffff)) {
    throw new RangeError(`flashbvh: distance ${distance} is no number of 1/256 cells`);
  }
  return posed(a, b, poses, [[Uint8Array, 1]], (a, b, poses, count, yes) =>
    library.closer_than(a, b, poses, count, distance, yes))[0];
};

export const firstPair = (a, b, poses) => {
  const [yes, triangles] = posed(a, b, poses, [[Uint8Array, 1], [Uint16Array, 2]], library.first_pairs);
  return { yes, triangles };
};

export const distance = (a, b, poses, { isMotion = false } = {}) => {
  const [lower, upper, pointA, pointB, triangles, inRange] = posed(a, b, poses,
    [[Uint32Array, 1], [Uint32Array, 1], [Float64Array, 3], [Float64Array, 3], [Uint16Array, 2], [Uint8Array, 1]],
    (a, b, poses, count, ...places) => library.distances(a, b, poses, count, isMotion, ...places));
  return { lower, upper, pointA, pointB, triangles, inRange };
};

export const nearestHit = (mesh, rays) => {
  need(mesh, Mesh, "mesh");
  const [yes, triangles, sides, distances, points] = answered(Float32Array, rays, 7, "ray",
    [[Uint8Array, 1], [Uint16Array, 1], [Int8Array, 1], [Uint32Array, 1], [Float64Array, 3]],
    (...places) => library.nearest_hits(mesh.place, ...places));
  return { yes, triangles, sides, distances, points };
};

export const inside = (mesh, points) => {
  need(mesh, Mesh, "mesh");
  return answered(Int32Array, points, 3, "point", [[Uint8Array, 1]],
    (...places) => library.inside(mesh.place, ...places))[0];
};

export const PointSide = Object.freeze({ outside: 0, onSurface: 1, inside: 2 });
export const Verdict = Object.freeze({ free: 0, warn: 1, notYetKnown: 2, stop: 3, refused: 4 });
export const ALL_WORK = 0xffffffff;
export const NO_PAIR = 0xffff;

const MOST_LINKS = 255;

export class Robot {
  constructor(bytes) {
    const [image, length] = image_in(bytes);
    const [place, meshes] = keep(this, take(ROBOT_BYTES), take(MOST_LINKS * MESH_BYTES), image);
    this.place = place;
    const status = library.flashbvh_open_robot(image, length, meshes, MOST_LINKS, place);
    if (status !== 0) refuse(status, "");
    const [variables, links, pairs, state] = view(Uint32Array, library.counts(place), 4);
    const named = (count, name) => Array.from({ length: count }, (_, i) => text_at(name(i)));
    this.name = text_at(library.flashbvh_robot_name(image));
    this.jointNames = named(variables, i => library.variable_name(image, place, i));
    this.linkNames = named(links, i => library.flashbvh_link_name(image, i));
    const [ends] = filled(pairs, "pair", [[Uint8Array, 2]], place => library.links_of_pairs(this.place, place));
    this.pairs = Array.from({ length: pairs }, (_, i) => [...ends.subarray(2 * i, 2 * i + 2)]);
    this.fine = library.cell(meshes) / 256;
    this.stateBytes = state;
  }

  values(floats) {
    const width = this.jointNames.length;
    return answered(Float32Array, floats, width, "value", [[Int32Array, width]], (...places) =>
      library.values_of(this.place, ...places))[0];
  }
}

export class Guard {
  constructor(robot) {
    this.robot = need(robot, Robot, "robot");
    const [place, state] = keep(this, take(GUARD_BYTES), take(robot.stateBytes));
    this.place = place;
    const status = library.flashbvh_guard_init(place, robot.place, state, robot.stateBytes);
    if (status !== 0) refuse(status, "");
  }

  prime(values) {
    this.forget();
    return this.check(values);
  }

  check(values, { work = ALL_WORK } = {}) {
    if (!(Number.isInteger(work) && work >= 1 && work <= ALL_WORK)) {
      throw new RangeError(`flashbvh: work ${work} is not 1 to ${ALL_WORK}`);
    }
    const [statuses, verdicts, pairs, distances, works] = answered(Int32Array, values, this.robot.jointNames.length, "period",
      [[Uint8Array, 1], [Uint8Array, 1], [Uint16Array, 1], [Uint32Array, 1], [Uint32Array, 1]],
      (count, place, ...places) => library.check(this.place, this.robot.place, count, place, work, ...places));
    return { statuses, verdicts, pairs, distances, works };
  }

  forget() {
    library.flashbvh_guard_forget(this.place);
  }
}

export const statusName = status_name;
