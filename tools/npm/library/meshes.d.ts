/**
 * Queries of baked meshes: flashbvh's C interface (flashbvh/*.h) as WebAssembly, in batches. The answers are those of
 * firmware, bit for bit. B lies at a pose in A's frame. Distances and points are in 1/256 cell where nothing else is
 * said: times `fine` of a mesh in its unit. Flags are 0 or 1. Results are copies, the caller's.
 *
 * What the library refuses is an Error whose `status` is the name of C's status, `image_corrupt` for instance, and
 * whose message has the row that is in error; then the whole batch has no answer. Other arguments are a TypeError or a
 * RangeError. An object's memory is freed some time after the object is dropped.
 */

import type { Floats, Image } from "./arrays.js";

/** A baked mesh with 16-bit indices, checked. Throws: image_truncated to image_invalid. */
export class Mesh {
  constructor(image: Image);
  private readonly place: number;
  /** The lattice's cell, in the unit. */
  readonly cell: number;
  /** 1/256 of the cell, in the unit. */
  readonly fine: number;
  /** "mm", for instance; "" if `bake` was given none. */
  readonly unit: string;
  readonly triangleCount: number;
  readonly isClosed: boolean;
}

/** Poses of B in A's frame; all meshes of one `bake` have the same. */
export class Poses {
  /** 12 numbers a pose, as `--poses` of the program has them: a rotation row by row, then a translation in the mesh's
   * unit. Throws: not_a_rotation, translation_out_of_range. */
  static fromMatrices(mesh: Mesh, numbers: Floats): Poses;
  /** 7 numbers a pose: w, x, y, z, then a translation in the mesh's unit. Throws: as fromMatrices. */
  static fromQuaternions(mesh: Mesh, numbers: Floats): Poses;
  private constructor();
  private readonly place: number;
  readonly length: number;
}

/** A flag a pose: whether any triangles intersect; touching counts. Throws: cell_mismatch, as all queries of two. */
export function intersects(a: Mesh, b: Mesh, poses: Poses): Uint8Array;

/** A flag a pose: whether two closed meshes have a point in common, insides included. Throws: not_closed. */
export function solidsIntersect(a: Mesh, b: Mesh, poses: Poses): Uint8Array;

/** A flag a pose: whether any points are at most `distance` apart. Throws: distance_out_of_range. */
export function closerThan(a: Mesh, b: Mesh, poses: Poses, distance: number): Uint8Array;

export interface FirstPairs {
  yes: Uint8Array;
  /** 2 ids a pose, of A's and B's triangle; 0 where there is no pair. */
  triangles: Uint16Array;
}
/** A pair of triangles that intersect, whichever is found first. */
export function firstPair(a: Mesh, b: Mesh, poses: Poses): FirstPairs;

export interface Distances {
  /** Rounded down; 0 if the meshes intersect. */
  lower: Uint32Array;
  /** Rounded up. */
  upper: Uint32Array;
  /** 3 numbers a pose, in A's frame: where the meshes are nearest. */
  pointA: Float64Array;
  pointB: Float64Array;
  /** 2 ids a pose: the triangles that are nearest. */
  triangles: Uint16Array;
  /** 0: the meshes are 2^20 cells or more apart; `lower` and `upper` hold, nothing else. */
  inRange: Uint8Array;
}
/** `isMotion`: each pose begins with the nearest pair of the one before, which is faster where they are near each other.
 * It changes no distance; of several nearest pairs, another may be reported. */
export function distance(a: Mesh, b: Mesh, poses: Poses, options?: { isMotion?: boolean }): Distances;

export interface Hits {
  yes: Uint8Array;
  /** Ids. Of rays that hit nothing, this and all that follows is 0. */
  triangles: Uint16Array;
  /** 1: the front is hit; -1: the back; 0: the edge of a plane. */
  sides: Int8Array;
  /** From the origin. */
  distances: Uint32Array;
  /** 3 numbers a ray. */
  points: Float64Array;
}
/** The first hit of each ray: 7 numbers, an origin, a direction of any length but 0 and how far the ray reaches, in the
 * mesh's unit. Throws: ray_out_of_range. */
export function nearestHit(mesh: Mesh, rays: Floats): Hits;

/** A PointSide for each point: 3 whole numbers of cells. Throws: not_closed. */
export function inside(mesh: Mesh, points: Int32Array): Uint8Array;
export const PointSide: { readonly outside: 0; readonly onSurface: 1; readonly inside: 2 };
