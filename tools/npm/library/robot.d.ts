/**
 * Baked robots and their guards: flashbvh's C interface (flashbvh/*.h) as WebAssembly, in batches. The answers are
 * those of firmware, bit for bit. Distances are in 1/256 cell: multiply by a robot's `fine` to get metres. Results are
 * copies that the caller owns.
 *
 * If the library refuses an argument, it throws an Error: `status` is the name of C's status, such as `image_corrupt`,
 * and the message names the failed row; the whole batch then has no answer. Other invalid arguments are a TypeError or
 * a RangeError. An object's memory is freed some time after the object is dropped.
 */

import type { Floats, Image } from "./arrays.js";

/** A baked robot, checked. Throws: image_truncated to image_invalid. */
export class Robot {
  constructor(image: Image);
  private readonly place: number;
  readonly name: string;
  /** The joints of the values, in the values' order. */
  readonly jointNames: string[];
  readonly linkNames: string[];
  /** The indices of both links of each guarded pair. */
  readonly pairs: [number, number][];
  /** 1/256 cell, in metres. */
  readonly fine: number;
  /** Converts radians and metres to rows of joint values for a guard. NaN and numbers that are too large become values
   * that every guard refuses. */
  values(floats: Floats): Int32Array;
}

export const Verdict: {
  readonly free: 0; readonly warn: 1; readonly notYetKnown: 2; readonly stop: 3; readonly refused: 4;
};

export interface GuardAnswers {
  /** C's statuses, 0 for done; statusName() gives the reason why values were refused. */
  statuses: Uint8Array;
  /** Verdict. */
  verdicts: Uint8Array;
  /** The pair, by its index in the robot's pairs, with the least clearance for this verdict; or NO_PAIR. */
  pairs: Uint16Array;
  /** A lower bound of the distance of this pair's links. */
  distances: Uint32Array;
  /** The spent work; 0 if ALL_WORK was granted. */
  works: Uint32Array;
}
/** A robot's guard. A new guard has no previous position. */
export class Guard {
  constructor(robot: Robot);
  private readonly place: number;
  /** At start-up: forgets everything, then runs check() with ALL_WORK. `values`: from Robot.values(). */
  prime(values: Int32Array): GuardAnswers;
  /** One period per row: from the last values to these, each joint monotonically. `work` per period: 1 to ALL_WORK,
   * which has no limit. */
  check(values: Int32Array, options?: { work?: number }): GuardAnswers;
  forget(): void;
}
export const ALL_WORK: number;
export const NO_PAIR: number;

/** The name of a status, such as "joint_jumped". */
export function statusName(status: number): string;
