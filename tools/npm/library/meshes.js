// Queries of baked meshes: flashbvh's C interface as WebAssembly, in batches. meshes.d.ts documents the results.
import { Module, need, need_whole } from "./module.js";

const module = await Module.open("meshes.wasm");
const { library } = module;
const [MESH_BYTES, POSE_BYTES] = module.view(Uint32Array, library.sizes(), 2);
const UNITS = ["", "nm", "um", "mm", "cm", "m", "mil", "in", "ft"];

export class Mesh {
  constructor(bytes) {
    const [image, length] = module.image_in(bytes);
    [this.place] = module.keep(this, module.take(MESH_BYTES), image);
    module.need_done(library.flashbvh_open(image, length, this.place));
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
    module.answered(Float32Array, numbers, width, "pose", [], (count, place) => {
      this.length = count;
      [this.place] = module.keep(this, module.take(Math.max(1, count * POSE_BYTES)));
      return make(mesh.place, count, place, this.place);
    });
  }
}

// Queries with B at each pose in A's frame: query(a, b, poses, count, ...places).
const posed = (a, b, poses, arrays, query) => {
  need(a, Mesh, "a");
  need(b, Mesh, "b");
  need(poses, Poses, "poses");
  return module.filled(poses.length, "pose", arrays,
    (...places) => query(a.place, b.place, poses.place, poses.length, ...places));
};

export const solidsIntersect = (a, b, poses) => posed(a, b, poses, [[Uint8Array, 1]], library.solids_intersect)[0];

export const closerThan = (a, b, poses, distance) => {
  need_whole(distance, 0, "distance");
  return posed(a, b, poses, [[Uint8Array, 1]], (a, b, poses, count, yes) =>
    library.closer_than(a, b, poses, count, distance, yes))[0];
};

export const firstPair = (a, b, poses) => {
  const [yes, triangles] = posed(a, b, poses, [[Uint8Array, 1], [Uint16Array, 2]], library.first_pairs);
  return { yes, triangles };
};

// Uses the search of firstPair().
export const intersects = (a, b, poses) => firstPair(a, b, poses).yes;

export const distance = (a, b, poses, { isMotion = false } = {}) => {
  const [lower, upper, pointA, pointB, triangles, inRange] = posed(a, b, poses,
    [[Uint32Array, 1], [Uint32Array, 1], [Float64Array, 3], [Float64Array, 3], [Uint16Array, 2], [Uint8Array, 1]],
    (a, b, poses, count, ...places) => library.distances(a, b, poses, count, isMotion, ...places));
  return { lower, upper, pointA, pointB, triangles, inRange };
};

export const nearestHit = (mesh, rays) => {
  need(mesh, Mesh, "mesh");
  const [yes, triangles, sides, distances, points] = module.answered(Float32Array, rays, 7, "ray",
    [[Uint8Array, 1], [Uint16Array, 1], [Int8Array, 1], [Uint32Array, 1], [Float64Array, 3]],
    (...places) => library.nearest_hits(mesh.place, ...places));
  return { yes, triangles, sides, distances, points };
};

export const PointSide = Object.freeze({ outside: 0, onSurface: 1, inside: 2 });

export const inside = (mesh, points) => {
  need(mesh, Mesh, "mesh");
  return module.answered(Int32Array, points, 3, "point", [[Uint8Array, 1]],
    (...places) => library.inside(mesh.place, ...places))[0];
};
