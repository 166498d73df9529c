// The page's title, its headlines, and tables of what --json prints: an object is a table of names and values, a list of
// objects a table with a row each. A row with joint values or a line of the trajectory shows them in the drawing.
const { command, title, headlines, facts, version, drawing } = JSON.parse(document.getElementById("page-data").textContent);

const words = name => name.replaceAll("_", " ");
const text_of = value => (value === null ? "\u2013" :
  Array.isArray(value) ? value.map(text_of).join(", ") :
  typeof value === "object" ? Object.entries(value).map(([name, of]) => `${words(name)} ${text_of(of)}`).join(", ") :
  typeof value === "boolean" ? (value ? "yes" : "no") :
  typeof value === "number" && !Number.isInteger(value) ? `${+value.toPrecision(6)}` : `${value}`);
const is_list = value => Array.isArray(value) && value.some(row => row && typeof row === "object" && !Array.isArray(row));

// Positions of the drawing by their names, such as "line 12 (0.35)".
const positions = drawing && drawing.names || [];
const at_line = line => positions.findIndex(name => parseInt(name.slice(5), 10) >= line);
const shown = (row, { witness, from }) => {
  if (witness && Object.keys(witness).length > 0) row.dataset.values = Object.values(witness).join(" ");
  if (from !== undefined && at_line(from) >= 0) row.dataset.period = at_line(from);
  return row;
};

const cell = (tag, value) => element(tag, { textContent: text_of(value ?? null), className: typeof value === "number" ? "n" : "" });
const verdict_class = verdict => `is-${verdict.replaceAll(" ", "-")}`;
const scrolled = table => element("div", { className: "scroll" }, table);

const list_table = (name, rows) => {
  const columns = [...new Set(rows.flatMap(row => Object.keys(row)))];
  const head = columns.map(column => element("th", { textContent: words(column), scope: "col" }));
  return scrolled(element("table", {}, element("caption", { textContent: words(name) }), element("thead", {}, element("tr", {}, ...head)),
    element("tbody", {}, ...rows.map(row => shown(element("tr", {}, ...columns.map((column, i) => cell(i === 0 ? "th" : "td", row[column]))), row)))));
};
const object_table = entries => scrolled(element("table", {}, element("tbody", {}, ...entries.map(([name, value]) =>
  element("tr", {}, element("th", { textContent: words(name), scope: "row" }), cell("td", value))))));

// Each pair of links, by its verdict.
const matrix = (links, pairs) => {
  const verdicts = new Map(pairs.flatMap(pair => [[`${pair.a}\n${pair.b}`, pair], [`${pair.b}\n${pair.a}`, pair]]));
  const names = links.map(({ name }) => name);
  const of = (a, b) => {
    const pair = verdicts.get(`${a}\n${b}`);
    return pair ? shown(element("td", { textContent: pair.verdict, className: verdict_class(pair.verdict) }), pair) : element("td", { textContent: "\u2013" });
  };
  const heads = scope => names.map(name => element("th", { textContent: name, scope }));
  return scrolled(element("table", { className: "matrix" }, element("caption", { textContent: "What can collide" }),
    element("thead", {}, element("tr", {}, element("td"), ...heads("col"))),
    element("tbody", {}, ...heads("row").map((head, i) => element("tr", {}, head, ...names.map(name => of(names[i], name)))))));
};

document.title = `${title} \u00b7 flashbvh ${command}`;
const at = id => document.getElementById(id);
at("title").textContent = title;
at("decision").append(...headlines.map(([verdict, text]) => element("li", {}, element("span", { className: `key v${verdict}` }), text)));
for (const part of facts) {
  const entries = Object.entries(part);
  const lists = entries.filter(([, value]) => is_list(value));
  const section = element("section");
  if (part.pairs && part.links && part.pairs.some(({ verdict }) => verdict)) section.append(matrix(part.links, part.pairs));
  section.append(...lists.map(([name, rows]) => list_table(name, rows)),
    object_table(entries.filter(([, value]) => !is_list(value) && !(Array.isArray(value) && value.length === 0))));
  at("facts").append(section);
}
at("facts").append(element("p", { className: "note", textContent: `${version}; numbers as --json prints them` }));
