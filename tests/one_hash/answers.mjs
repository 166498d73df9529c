// The hash of sequence.cpp, computed by the npm package: in node and, by everywhere.py, in a browser.
// `library`: the package; read(name): the bytes of a file that one_hash writes.
const BLOCK = 1000, ALL_WORK = 0xfffffffe, WORK = 150;
const KINDS = [
  (library, a, b, poses) => [library.intersects(a, b, poses)],
  (library, a, b, poses) => {
    const { lower, upper, triangles, pointA, pointB } = library.distance(a, b, poses);
    return [lower, upper, words_of(triangles), ...columns_of(pointA), ...columns_of(pointB)];
  },
  (library, a, b, poses) => {
    const { yes, triangles } = library.firstPair(a, b, poses);
    return [yes, words_of(triangles)];
  },
];

const words_of = pairs => new Uint32Array(pairs.buffer);
const columns_of = points => [0, 1, 2].map(axis => points.filter((_, i) => i % 3 === axis));

// FNV-1a by words, row after row of all columns.
let hash = 2166136261;
const add = columns => {
  for (let i = 0; i < columns[0].length; ++i) {
    for (const column of columns) hash = Math.imul(hash ^ column[i], 16777619);
  }
};

export const hash_of = async (library, read) => {
  const meshes = [];
  for (const name of ["torus", "lump", "gear"]) meshes.push(new library.Mesh(await read(`${name}.fbvh`)));
  const floats = new Float32Array(await read("poses"));
  for (let block = 0; block * 12 * BLOCK < floats.length; ++block) {
    const a = Math.floor(block / KINDS.length) % meshes.length;
    const poses = library.Poses.fromMatrices(meshes[a], floats.subarray(block * 12 * BLOCK, (block + 1) * 12 * BLOCK));
    add(KINDS[block % KINDS.length](library, meshes[a], meshes[(a + 1) % meshes.length], poses));
  }
  const robot = new library.Robot(await read("arm.robot"));
  const values = robot.values(new Float32Array(await read("values")));
  const guard = new library.Guard(robot);
  const first = robot.jointNames.length;
  for (const [rows, work] of [[values.subarray(0, first), ALL_WORK], [values.subarray(first), WORK]]) {
    const { verdicts, pairs, distances, works } = guard.check(rows, { work });
    add([verdicts, pairs, distances, works]);
  }
  return (hash >>> 0).toString(16).toUpperCase().padStart(8, "0");
};

// answers.mjs PACKAGE FOLDER
if (globalThis.process) {
  const { readFile } = await import("node:fs/promises");
  const { pathToFileURL } = await import("node:url");
  const [, , folder, inputs] = process.argv;
  const read = async name => new Uint8Array(await readFile(`${inputs}/${name}`)).buffer;
  console.log(await hash_of(await import(pathToFileURL(`${folder}/index.js`)), read));
}
