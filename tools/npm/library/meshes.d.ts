/**
 * Queries of baked meshes: flashbvh's C interface (flashbvh/*.h) as WebAssembly, in batches. The answers are those of
 * firmware, bit for bit. A pose places B in A's frame. Unless stated otherwise, distances and points are in 1/256 cell:
 * multiply by a mesh's `fine` to get its unit. Flags are 0 or 1. Results are copies that the caller owns.
 *
 * If the library refuses an argument, it throws an Error: `status` is the name of C's status, such as `image_corrupt`,
 * and the message names the failed row; the whole batch then has no answer. Other invalid arguments are a TypeError or
 * a RangeError. An object's memory is freed some time after the object is dropped.
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
  /** For instance "mm"; "" if `bake` was given no unit. */
  readonly unit: string;
  readonly triangleCount: number;
  readonly isClosed: boolean;
}

/** Poses of B in A's frame; all meshes of one `bake` can share them. */
export class Poses {
  /** 12 numbers per pose, as in the program's `--poses`: a rotation row by row, then a translation in the mesh's
   * unit. Throws: not_a_rotation, translation_out_of_range. */
  static fromMatrices(mesh: Mesh, numbers: Floats): Poses;
  /** 7 numbers per pose: w, x, y, z, then a translation in the mesh's unit. Throws as fromMatrices does. */
  static fromQuaternions(mesh: Mesh, numbers: Floats): Poses;
  private constructor();
  private readonly place: number;
  readonly length: number;
}

/** A flag per pose: whether any triangles intersect; touching counts. Throws: cell_mismatch, like all such queries. */
export function intersects(a: Mesh, b: Mesh, poses: Poses): Uint8Array;

/** A flag per pose: whether two closed meshes have a point in common, insides included. Throws: not_closed. */
export function solidsIntersect(a: Mesh, b: Mesh, poses: Poses): Uint8Array;

/** A flag per pose: whether any points are at most `distance` apart. Throws: distance_out_of_range. */
export function closerThan(a: Mesh, b: Mesh, poses: Poses, distance: number): Uint8Array;

export interface FirstPairs {
  yes: Uint8Array;
  /** 2 ids per pose, of A's and B's triangle; 0 if there is no pair. */
  triangles: Uint16Array;
}
/** The first pair of intersecting triangles that the query finds. */
export function firstPair(a: Mesh, b: Mesh, poses: Poses): FirstPairs;

export interface Distances {
  /** Rounded down; 0 if the meshes intersect. */
  lower: Uint32Array;
  /** Rounded up. */
  upper: Uint32Array;
  /** 3 numbers per pose, in A's frame: the nearest points. */
  pointA: Float64Array;
  pointB: Float64Array;
  /** 2 ids per pose: the nearest triangles. */
  triangles: Uint16Array;
  /** 0: the meshes are 2^20 cells or more apart; then only `lower` and `upper` are valid. */
  inRange: Uint8Array;
}
/** `isMotion`: each pose starts with the last nearest pair as a hint, which is faster if poses are close together.
 * Distances do not change; of several nearest pairs, the query may report another. */
export function distance(a: Mesh, b: Mesh, poses: Poses, options?: { isMotion?: boolean }): Distances;

export interface Hits {
  yes: Uint8Array;
  /** Ids. If a ray hits nothing, its triangle and all fields below are 0. */
  triangles: Uint16Array;
  /** 1: the front is hit; -1: the back; 0: the edge of a plane. */
  sides: Int8Array;
  /** From the origin. */
  distances: Uint32Array;
  /** 3 numbers per ray. */
  points: Float64Array;
}
/** The first hit of each ray: 7 numbers, an origin, a direction of any length but 0 and the ray's reach, in the mesh's
 * unit. Throws: ray_out_of_range. */
export function nearestHit(mesh: Mesh, rays: Floats): Hits;

/** A PointSide for each point, of 3 whole numbers of cells. Throws: not_closed. */
export function inside(mesh: Mesh, points: Int32Array): Uint8Array;
export const PointSide: { readonly outside: 0; readonly onSurface: 1; readonly inside: 2 };
