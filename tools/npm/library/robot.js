// Baked robots and their guards: flashbvh's C interface as WebAssembly, in batches. robot.d.ts documents the results.
import { Module, need, need_whole } from "./module.js";

const module = await Module.open("robot.wasm");
const { library } = module;
const [MESH_BYTES, ROBOT_BYTES, GUARD_BYTES] = module.view(Uint32Array, library.sizes(), 3);
const MOST_LINKS = 255;

export const Verdict = Object.freeze({ free: 0, warn: 1, notYetKnown: 2, stop: 3, refused: 4 });
export const ALL_WORK = 0xffffffff;
export const NO_PAIR = 0xffff;
export const statusName = status => module.status_name(status);

export class Robot {
  constructor(bytes) {
    const [image, length] = module.image_in(bytes);
    const [place, meshes] = module.keep(this, module.take(ROBOT_BYTES), module.take(MOST_LINKS * MESH_BYTES), image);
    this.place = place;
    module.need_done(library.flashbvh_open_robot(image, length, meshes, MOST_LINKS, place));
    const [joints, links, pairs, state] = module.view(Uint32Array, library.counts(image), 4);
    const named = (count, name) => Array.from({ length: count }, (_, i) => module.text(name(i)));
    this.name = module.text(library.flashbvh_robot_name(image));
    this.jointNames = named(joints, i => library.variable_name(image, place, i));
    this.linkNames = named(links, i => library.flashbvh_link_name(image, i));
    const [ends] = module.filled(pairs, "pair", [[Uint8Array, 2]], ends => library.links_of_pairs(place, ends));
    this.pairs = Array.from({ length: pairs }, (_, i) => [...ends.subarray(2 * i, 2 * i + 2)]);
    this.fine = library.cell(place) / 256;
    this.stateBytes = state;
  }

  values(floats) {
    const width = this.jointNames.length;
    return module.answered(Float32Array, floats, width, "value", [[Int32Array, width]],
      (...places) => library.values_of(this.place, ...places))[0];
  }
}

export class Guard {
  constructor(robot) {
    this.robot = need(robot, Robot, "robot");
    const [place, state] = module.keep(this, module.take(GUARD_BYTES), module.take(robot.stateBytes));
    this.place = place;
    module.need_done(library.flashbvh_guard_init(place, robot.place, state, robot.stateBytes));
  }

  prime(values) {
    this.forget();
    return this.check(values);
  }

  check(values, { work = ALL_WORK } = {}) {
    need_whole(work, 1, "work");
    const [statuses, verdicts, pairs, distances, works] = module.answered(Int32Array, values,
      this.robot.jointNames.length, "period",
      [[Uint8Array, 1], [Uint8Array, 1], [Uint16Array, 1], [Uint32Array, 1], [Uint32Array, 1]],
      (count, place, ...places) => library.check(this.place, this.robot.place, count, place, work, ...places));
    return { statuses, verdicts, pairs, distances, works };
  }

  forget() {
    library.flashbvh_guard_forget(this.place);
  }
}
