/**
 * Baked robots and their guards: flashbvh's C interface (flashbvh/*.h) as WebAssembly, in batches. The answers are
 * those of firmware, bit for bit. Distances are in 1/256 cell: times `fine` of a robot in metres. Results are copies, the
 * caller's.
 *
 * What the library refuses is an Error whose `status` is the name of C's status, `image_corrupt` for instance, and
 * whose message has the row that is in error; then the whole batch has no answer. Other arguments are a TypeError or a
 * RangeError. An object's memory is freed some time after the object is dropped.
 */

import type { Floats, Image } from "./arrays.js";

/** A baked robot, checked. Throws: image_truncated to image_invalid. */
export class Robot {
  constructor(image: Image);
  private readonly place: number;
  readonly name: string;
  /** The joints that the values are of, in their order. */
  readonly jointNames: string[];
  readonly linkNames: string[];
  /** The numbers of both links of each guarded pair. */
  readonly pairs: [number, number][];
  /** 1/256 cell, in metres. */
  readonly fine: number;
  /** Rows of joint values as a guard takes them, of radians and metres. What is no number or too large becomes a value
   * that every guard refuses. */
  values(floats: Floats): Int32Array;
}

export const Verdict: {
  readonly free: 0; readonly warn: 1; readonly notYetKnown: 2; readonly stop: 3; readonly refused: 4;
};

export interface GuardAnswers {
  /** Of C's statuses, 0 being done: statusName() of why values were refused. */
  statuses: Uint8Array;
  /** Verdict. */
  verdicts: Uint8Array;
  /** Of the robot's pairs, that of the least clearance with this verdict; or NO_PAIR. */
  pairs: Uint16Array;
  /** The links of this pair stayed at least so far apart: what is known. */
  distances: Uint32Array;
  /** Spent; 0 where ALL_WORK was granted. */
  works: Uint32Array;
}
/** A robot's guard, which knows nothing yet. */
export class Guard {
  constructor(robot: Robot);
  private readonly place: number;
  /** At start-up: forgets all, then check() with ALL_WORK. `values`: of Robot.values(). */
  prime(values: Int32Array): GuardAnswers;
  /** A period a row: from the last values to these, each joint monotonically. `work` of a period: 1 to ALL_WORK, which is
   * without limit. */
  check(values: Int32Array, options?: { work?: number }): GuardAnswers;
  forget(): void;
}
export const ALL_WORK: number;
export const NO_PAIR: number;

/** "joint_jumped", for instance. */
export function statusName(status: number): string;
