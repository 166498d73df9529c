// answers.mjs PAGE KNOWN: fails unless the library in the page gives the answers in KNOWN, a JSON file of live_answers.
import { readFileSync } from "node:fs";
const [page, known] = process.argv.slice(2).map(file => readFileSync(file, "utf8"));
const { drawing } = JSON.parse(/id=page-data>(.*?)<\/script>/.exec(page)[1]);
const compiled = await WebAssembly.compile(Buffer.from(/id=library>(.*?)<\/script>/.exec(page)[1], "base64"));
if (WebAssembly.Module.imports(compiled).length !== 0) throw new Error("the library imports something");
const library = (await WebAssembly.instantiate(compiled)).exports;
(drawing.meshes || [drawing]).forEach(({ image }, i) => {
  const bytes = Buffer.from(image, "base64");
  const place = library.room(bytes.length);  // may replace the buffer
  new Uint8Array(library.memory.buffer).set(bytes, place);
  const status = drawing.meshes ? library.open_as_mesh(i, bytes.length) : library.open_as_robot(bytes.length);
  if (status !== 0) throw new Error(`an image is refused: ${status}`);
});
const words = (place, length) => new Int32Array(library.memory.buffer, place, length);

const answer_of_robot = values => {
  values.forEach((value, variable) => library.set_coordinate(variable, value));
  return words(library.verdict(), 4);
};
const answer_of_pair = (pose, wanted) => {
  words(library.pose_words(), 15).set(pose);
  library.place();
  const place = library.measure(0, 1);
  const [, pairs, inside, , lower, a, b] = words(place, 7);
  const points = new Float64Array(library.memory.buffer, place + 32, 6).map(part => 256 * part);
  const [, outcome, to] = wanted.length > 7 ? words(library.certify(0, 1), 3) : [];
  return [pairs, inside, lower, a, b, points[0], points[5], outcome, to];
};
const { ends, queries } = JSON.parse(known);
(ends || []).forEach(([lower, upper], variable) => {
  const found = [library.lower, library.upper].map(end => library.set_value(variable, end(variable)));
  if (found[0] !== lower || found[1] !== upper) throw new Error(`variable ${variable} ends at ${found}`);
});
for (const [query, wanted] of queries) {
  const found = drawing.meshes ? answer_of_pair(query, wanted) : answer_of_robot(query);
  if (wanted.some((part, i) => part !== found[i])) throw new Error(`${query}: ${found}, not ${wanted}`);
}
