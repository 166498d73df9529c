// answers_test.mjs PACKAGE INPUTS FLASHBVH: the npm package answers like the program, and refuses
// invalid arguments. INPUTS: a program that writes images, poses and joint values (tests/one_hash).
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";

const [, , folder, inputs, flashbvh] = process.argv;
const library = await import(pathToFileURL(join(folder, "index.js")));
const { Guard, Mesh, Poses, PointSide, Robot, Verdict } = library;
const work = mkdtempSync(join(tmpdir(), "flashbvh_npm_"));
process.on("exit", () => rmSync(work, { recursive: true }));
const COUNT = 300, PERIODS = 10000;
execFileSync(inputs, [COUNT, PERIODS, work]);

const image = name => new Uint8Array(readFileSync(join(work, name)));
const floats = name => new Float32Array(image(name).buffer);
const row = (numbers, width, i) => [...numbers.subarray(i * width, (i + 1) * width)];
const rows = (numbers, width) => Array.from({ length: numbers.length / width }, (_, i) => row(numbers, width, i));
const write = (name, lines, head = []) => {
  writeFileSync(join(work, name), [...head, ...lines].map(line => `${line}\n`).join(""));
  return join(work, name);
};
// The program's JSON objects, one per line; it exits with 0, or with 1 on a finding.
const program = (...options) => {
  const { status, stdout, stderr } = spawnSync(flashbvh, [...options, "--json"], { cwd: work, encoding: "utf8", maxBuffer: 1e8 });
  assert(status === 0 || status === 1 || status === 3, stderr);
  return stdout.trim().split("\n").map(line => JSON.parse(line));
};
const refused = (status, call) => assert.throws(call, error => error.status === status && error.message.includes(status));

const a = new Mesh(image("torus.fbvh")), b = new Mesh(image("lump.fbvh").buffer);
const numbers = floats("poses");
const poses = Poses.fromMatrices(a, numbers);
const posed = (command, ...options) => program(command, "torus.fbvh", "lump.fbvh", "--poses",
  write("poses.txt", rows(numbers, 12).map(pose => pose.join(" "))), "--float", ...options);
const flags = answers => answers.map(yes => (yes ? 1 : 0));
const length = (steps, mesh) => steps * mesh.fine;

const tests = {
  "a mesh has the facts of its image"() {
    assert.deepEqual([a.unit, a.cell, a.fine * 256, a.triangleCount, a.isClosed], ["mm", 0.005, 0.005, 576, true]);
    assert.equal(poses.length, COUNT);
  },

  "intersections are the program's"() {
    const found = library.intersects(a, b, poses);
    assert(new Set(found).size === 2);
    assert.deepEqual([...found], flags(posed("collide").map(line => line.intersects)));
    assert.deepEqual([...library.solidsIntersect(a, b, poses)],
      flags(posed("collide").map(line => line.intersects || line.inside)));
  },

  "a first pair is one of all, and there is one where the meshes intersect"() {
    const { yes, triangles } = library.firstPair(a, b, poses);
    assert.deepEqual(yes, library.intersects(a, b, poses));
    posed("collide", "--pairs", "pairs.txt");
    const all = new Set(readFileSync(join(work, "pairs.txt"), "utf8").trim().split("\n"));
    rows(triangles, 2).forEach((pair, i) => assert(!yes[i] || all.has([i, ...pair].join(" "))));
  },

  "distances are the program's"() {
    for (const [isMotion, options] of [[false, ["--cold"]], [true, []]]) {
      const found = library.distance(a, b, poses, { isMotion });
      posed("clearance", ...options).forEach((line, i) => {
        assert.deepEqual([length(found.lower[i], a), length(found.upper[i], a)], [line.lower, line.upper]);
        assert.deepEqual(row(found.triangles, 2, i), line.triangles);
        assert.deepEqual(row(found.pointA, 3, i).map(x => length(x, a)), line.point_a);
        assert.deepEqual(row(found.pointB, 3, i).map(x => length(x, a)), line.point_b);
      });
      assert(found.inRange.every(yes => yes === 1));
    }
    const far = Poses.fromQuaternions(a, [1, 0, 0, 0, 1e5, 0, 0]);
    const { inRange, lower } = library.distance(a, b, far);
    assert(inRange[0] === 0 && lower[0] > 0);
  },

  "within a distance is as the program has it"() {
    const found = library.closerThan(a, b, poses, Math.floor(5 / a.fine));
    assert(new Set(found).size === 2);
    assert.deepEqual([...found], flags(posed("clearance", "--within", "5").map(line => line.within)));
    const { lower, upper } = library.distance(a, b, poses);
    const i = lower.findIndex(steps => steps > 0);
    assert.deepEqual([lower[i] - 1, upper[i]].map(steps => library.closerThan(a, b, poses, steps)[i]), [0, 1]);
  },

  "hits of rays are the program's"() {
    const rays = Float32Array.from(rows(numbers, 12).flatMap(pose =>
      [...pose.slice(9), ...pose.slice(0, 3).map((x, i) => 4 * x - pose[9 + i] / 8), 100]));
    const found = library.nearestHit(a, rays);
    const sides = { front: 1, back: -1, edge: 0 };
    program("ray", "torus.fbvh", "--rays", write("rays.txt", rows(rays, 7).map(ray => ray.join(" ")))).forEach((line, i) => {
      assert.equal(found.yes[i] === 1, line.hit);
      if (!line.hit) return;
      assert.deepEqual([found.triangles[i], found.sides[i], length(found.distances[i], a)],
        [line.triangle, sides[line.side], line.distance]);
      assert.deepEqual(row(found.points, 3, i).map(x => length(x, a)), line.point);
    });
    assert(new Set(found.yes).size === 2);
  },

  "points are inside as the program has it"() {
    const points = Int32Array.from(rows(numbers, 12).flatMap(pose => pose.slice(9).map(x => Math.round(x / 2 / a.cell))));
    const found = library.inside(b, points);
    const lines = program("inside", "lump.fbvh", "--points",
      write("points.txt", rows(points, 3).map(point => point.map(x => x * a.cell).join(" "))));
    assert(new Set(found).size >= 2);
    assert.deepEqual([...found], lines.map(line => ({ outside: PointSide.outside, surface: PointSide.onSurface,
      inside: PointSide.inside })[line.where]));
  },

  "quaternions make the poses of their matrices"() {
    const turns = [[1, 0, 0, 0], [0, 1, 0, 0], [Math.SQRT1_2, 0, 0, Math.SQRT1_2]];
    const matrices = [[1, 0, 0, 0, 1, 0, 0, 0, 1], [1, 0, 0, 0, -1, 0, 0, 0, -1], [0, -1, 0, 1, 0, 0, 0, 0, 1]];
    const at = [20.5, 7, -3];
    const [one, other] = [Poses.fromQuaternions(a, turns.flatMap(turn => [...turn, ...at])),
      Poses.fromMatrices(a, matrices.flatMap(matrix => [...matrix, ...at]))].map(poses => library.distance(a, b, poses));
    assert.deepEqual(one, other);
  },

  "a guard's answers are the program's"() {
    const robot = new Robot(image("arm.robot"));
    assert.deepEqual(robot.jointNames, ["turn", "shoulder", "elbow", "roll"]);
    const radians = floats("values");
    const values = robot.values(radians);
    const csv = write("values.csv", rows(radians, 4).map(line => line.join(",")), [robot.jointNames.join(",")]);
    const lines = program("guard", "arm.robot", csv, "--work", "150");
    const names = ["free", "warn", "not_yet_known", "stop", "refused"];
    const guard = new Guard(robot);
    const parts = [guard.prime(values.subarray(0, 4)), guard.check(values.subarray(4, 404), { work: 150 }),
      guard.check(values.subarray(404), { work: 150 })];
    const found = Object.fromEntries(Object.keys(parts[0]).map(name => [name, parts.flatMap(part => [...part[name]])]));
    assert.deepEqual(found.verdicts, lines.map(line => names.indexOf(line.verdict)));
    assert.deepEqual(found.works.slice(1), lines.slice(1).map(line => line.work));
    assert.deepEqual(found.pairs.map(pair => (robot.pairs[pair] ?? []).map(link => robot.linkNames[link])),
      lines.map(({ a, b }) => (a === null ? [] : [a, b])));
    lines.forEach(({ distance }, i) => assert(distance === null || distance === length(found.distances[i], robot)));
    assert(names.every((_, verdict) => found.verdicts.includes(verdict)), "every verdict occurs");
    const refusal = found.verdicts.indexOf(Verdict.refused);
    assert.equal(library.statusName(found.statuses[refusal]), "joint_out_of_limits");
    assert.deepEqual(guard.prime(values.subarray(0, 4)), parts[0]);
    guard.forget();
    assert.deepEqual(guard.check(values.subarray(0, 4)), parts[0]);
  },

  "what the library refuses has its status"() {
    const bytes = image("torus.fbvh");
    refused("image_truncated", () => new Mesh(bytes.subarray(0, 1000)));
    refused("image_truncated", () => new Mesh(new Uint8Array()));
    refused("image_not_flashbvh", () => new Mesh(bytes.subarray(4)));
    refused("image_not_flashbvh", () => new Robot(bytes));
    bytes[500] ^= 1;
    refused("image_corrupt", () => new Mesh(bytes));
    assert.throws(() => Poses.fromMatrices(a, [...row(numbers, 12, 0), ...Array(12).fill(1)]), /not_a_rotation: pose 1$/);
    assert.throws(() => Poses.fromQuaternions(a, [1, 0, 0, 0, NaN, 0, 0]), /translation_out_of_range: pose 0$/);
    refused("ray_out_of_range", () => library.nearestHit(a, [0, 0, 0, 0, 0, 0, 1]));
    refused("distance_out_of_range", () => library.closerThan(a, b, poses, 0xffffffff));
    const sheet = write("sheet.obj", ["v 0 0 0", "v 1 0 0", "v 0 1 0", "f 1 2 3"]);
    execFileSync(flashbvh, ["bake", sheet, "--cell", "0.01", "--format", "image", "-o", work], { stdio: "ignore" });
    const open = new Mesh(image("sheet.fbvh"));
    refused("cell_mismatch", () => library.intersects(a, open, poses));
    refused("not_closed", () => library.inside(open, Int32Array.of(0, 0, 0)));
  },

  "arguments of another type or length are refused"() {
    for (const call of [() => new Mesh("torus.fbvh"), () => library.intersects(a, {}, poses), () => library.intersects({}, b, poses),
      () => new Guard(a), () => library.intersects(a, b, numbers), () => library.inside(a, [0, 0, 0]), () => Poses.fromMatrices(a, "1")]) {
      assert.throws(call, { name: "TypeError", message: /^flashbvh: .* is no / });
    }
    const guard = new Guard(new Robot(image("arm.robot")));
    for (const call of [() => Poses.fromMatrices(a, numbers.subarray(1)), () => guard.check(new Int32Array(5)),
      () => guard.check(new Int32Array(4), { work: 0 }), () => library.closerThan(a, b, poses, -1)]) {
      assert.throws(call, { name: "RangeError", message: /^flashbvh: / });
    }
  },

  "nothing in, nothing out"() {
    assert.equal(library.intersects(a, b, Poses.fromMatrices(a, [])).length, 0);
    assert.equal(library.nearestHit(a, []).yes.length, 0);
  },

  async "the memory of dropped objects is used again"() {
    const robot = new Robot(image("arm.robot"));
    const batch = new Float32Array(4000);
    const held = () => process.memoryUsage().external;
    const before = held();
    for (let i = 0; i < 400; ++i) {
      Poses.fromMatrices(a, numbers);
      robot.values(batch);
      if (i % 20 === 0) {
        globalThis.gc();
        await new Promise(setImmediate);
      }
    }
    globalThis.gc();
    assert(held() - before < 4e6, `${held() - before} bytes more`);
  },

  "the types name what there is"() {
    const types = ["meshes.d.ts", "robot.d.ts"].map(name => readFileSync(join(folder, name), "utf8")).join("");
    const declared = types.matchAll(/^export (?:class|function|const) (\w+)/gm);
    assert.deepEqual([...declared].map(match => match[1]).sort(), Object.keys(library).sort());
  },

  "the modules import nothing"() {
    for (const name of ["meshes.wasm", "robot.wasm"]) {
      const bytes = readFileSync(join(folder, name));
      assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(bytes)), []);
      console.log(`  ${name}: ${bytes.length} bytes, ${gzipSync(bytes, { level: 9 }).length} compressed`);
    }
  },
};

for (const [name, test] of Object.entries(tests)) {
  await test();
  console.log(`ok: ${name}`);
}
