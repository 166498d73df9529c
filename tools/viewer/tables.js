// The page's title, what to do, other headlines, and tables of what one decides by of what --json prints: an object is a
// table of names and values, a list of objects a table with a row each. A row with joint values or a line of the
// trajectory shows them in the drawing.
const { command, title, headlines, facts, version, drawing } = JSON.parse(document.getElementById("page-data").textContent);

const words = name => name.replaceAll("_", " ");
const text_of = value => (value === null ? "\u2013" :
  Array.isArray(value) ? value.map(text_of).join(", ") :
  typeof value === "boolean" ? (value ? "yes" : "no") :
  typeof value === "number" && !Number.isInteger(value) ? `${+value.toPrecision(4)}` : `${value}`);
const is_list = value => Array.isArray(value) && value.some(row => row && typeof row === "object" && !Array.isArray(row));

// Positions of the drawing by their names, such as "line 12 (0.35)".
const positions = drawing && drawing.names || [];
const at_line = line => positions.findIndex(name => parseInt(name.slice(5), 10) >= line);
const shown = (row, { witness, values = witness, from }) => {
  if (values && Object.keys(values).length > 0) row.dataset.values = Object.values(values).join(" ");
  else if (from !== undefined && at_line(from) >= 0) row.dataset.period = at_line(from);
  return row;
};

const cell = (tag, value) => element(tag, { textContent: text_of(value ?? null), className: typeof value === "number" ? "n" : "" });
const scrolled = table => element("div", { className: "scroll" }, table);

// Lengths, which are metres of a robot, and their names and values in mm.
const LENGTHS = new Set(command === "report" ? [] : ["radius", "size", "deviation", "cell", "simplified", "distance", "closest"]);
const label = name => words(name) + (LENGTHS.has(name) ? ", mm" : "");
const in_mm = (name, value) => (!LENGTHS.has(name) ? value : Array.isArray(value) ? value.map(part => in_mm(name, part)) :
  typeof value === "number" ? 1000 * value : value);

// What headlines, the matrix or the drawing show too, and the most rows of a table.
const ELSEWHERE = new Set(["name", "not_guarded", "pairs", "joints", "periods", "middle", "values", "sources"]), MOST_ROWS = 30;
const OF_MESHES = ["name", "triangles", "bytes", "closed", "shells", "size", "deviation", "unit"];

const list_table = (name, all) => {
  const rows = all.slice(0, MOST_ROWS);
  const columns = [...new Set(rows.flatMap(row => Object.keys(row)))].filter((column, i) => i === 0 || !ELSEWHERE.has(column));
  const caption = words(name) + (rows.length < all.length ? `, the first ${MOST_ROWS} of ${all.length}; --json has all` : "");
  const head = columns.map(column => element("th", { textContent: label(column), scope: "col" }));
  return scrolled(element("table", {}, element("caption", { textContent: caption }), element("thead", {}, element("tr", {}, ...head)),
    element("tbody", {}, ...rows.map(row => shown(element("tr", {}, ...columns.map((column, i) => cell(i === 0 ? "th" : "td", in_mm(column, row[column])))), row)))));
};
const object_table = entries => scrolled(element("table", {}, element("tbody", {}, ...entries.map(([name, value]) =>
  element("tr", {}, element("th", { textContent: label(name), scope: "row" }), cell("td", in_mm(name, value)))))));

// Each pair of links once, by its verdict, with its reason when pointed at.
const matrix = (links, pairs) => {
  const verdicts = new Map(pairs.flatMap(pair => [[`${pair.a}\n${pair.b}`, pair], [`${pair.b}\n${pair.a}`, pair]]));
  const names = [...new Set(links.map(({ name }) => name))];  // parts of links have the names of these
  const of = pair => shown(element("td", {
    textContent: pair.verdict, title: pair.reason, className: `is-${pair.verdict.replaceAll(" ", "-")}` }), pair);
  const heads = scope => names.map(name => element("th", { scope }, element("span", { textContent: name })));
  return scrolled(element("table", { className: "matrix" }, element("caption", { textContent: "What can collide" }),
    element("thead", {}, element("tr", {}, element("td"), ...heads("col").slice(0, -1))),
    element("tbody", {}, ...heads("row").map((head, i) => element("tr", {}, head, ...names.slice(0, i).map(name => of(verdicts.get(`${names[i]}\n${name}`))))).slice(1))));
};

document.title = `${title} \u00b7 flashbvh ${command}`;
const at = id => document.getElementById(id);
at("title").textContent = title;
const lines = headlines.map(([verdict, text]) => element("li", {}, element("span", { className: `key v${verdict}` }), text));
at("advice").append(...lines.splice(0, 1));
at("decision").append(...lines);
at("decision").parentNode.hidden = lines.length === 0;
const of_meshes = { meshes: facts.map(part => Object.fromEntries(OF_MESHES.map(name => [name, part[name]]))) };
for (const part of command === "report" ? [of_meshes] : facts) {
  const entries = Object.entries(part).filter(([name]) => !ELSEWHERE.has(name));
  const lists = entries.filter(([, value]) => is_list(value));
  const section = element("section");
  if (part.pairs && part.links && part.pairs.some(({ verdict }) => verdict)) section.append(matrix(part.links, part.pairs));
  section.append(...lists.map(([name, rows]) => list_table(name, rows)),
    object_table(entries.filter(([, value]) => !is_list(value) && !(Array.isArray(value) && value.length === 0))));
  at("facts").append(section);
}
at("facts").append(element("p", { className: "note", textContent: `${version}; --json prints all` }));
