// Compiled by tests/release/npm_library.sh: uses that the types accept, and uses that they refuse.
import { Mesh, Poses, closerThan, distance, firstPair, inside, intersects, nearestHit, solidsIntersect }
  from "flashbvh-library";
import { ALL_WORK, Guard, NO_PAIR, Robot, Verdict, statusName } from "flashbvh-library/robot";

const mesh = new Mesh(new ArrayBuffer(80));
const facts: [number, number, string, number, boolean] =
  [mesh.cell, mesh.fine, mesh.unit, mesh.triangleCount, mesh.isClosed];
const poses = Poses.fromMatrices(mesh, new Float32Array(12));
const same: Poses = Poses.fromQuaternions(mesh, [1, 0, 0, 0, 0, 0, 0]);
const flags: Uint8Array[] = [intersects(mesh, mesh, poses), solidsIntersect(mesh, mesh, poses),
  closerThan(mesh, mesh, poses, 256), firstPair(mesh, mesh, same).yes, inside(mesh, new Int32Array(3))];
const metres: number[] = [...distance(mesh, mesh, poses, { isMotion: true }).lower].map(steps => steps * mesh.fine);
const points: Float64Array = nearestHit(mesh, [0, 0, 0, 1, 0, 0, 10]).points;
const robot = new Robot(new Uint8Array(52));
const guard = new Guard(robot);
const { verdicts, pairs, statuses } = guard.check(robot.values(new Float64Array(4)), { work: ALL_WORK });
const first: [number, number] | undefined = pairs[0] === NO_PAIR ? undefined : robot.pairs[pairs[0]];
const why: string = statusName(statuses[0]);
const stops: boolean = verdicts[0] >= Verdict.stop;

// @ts-expect-error: floats are no joint values
guard.check([0, 0, 0, 0]);
// @ts-expect-error: numbers are no poses
intersects(mesh, mesh, new Float32Array(12));
// @ts-expect-error: made by from... alone
new Poses();
// @ts-expect-error: a fact
mesh.cell = 1;

export { facts, first, flags, metres, points, stops, why };
