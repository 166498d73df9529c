// Begins the page's drawing, if it has one.

// Elements with this data attribute show their value in the drawing when clicked or chosen by keyboard.
const offer = (section, name, set) => {
  for (const place of document.querySelectorAll(`[data-${name}]`)) {
    place.tabIndex = 0;
    place.setAttribute("role", "button");
    place.onclick = () => {
      set(place.dataset[name]);
      section.scrollIntoView({ behavior: "smooth", block: "nearest" });
    };
    place.onkeydown = event => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      place.onclick();
    };
  }
};

// A choice of one of several: `make(i)` makes its stage.
const choose = (section, names, make) => {
  const place = element("div");
  let stage;
  const show = i => {
    if (stage) stage.view.close();
    stage = window.live = make(i);
    place.replaceChildren(stage.box);
    stage.begin();
  };
  const choice = element("select", { onchange: () => show(+choice.value) },
    ...names.map((textContent, value) => element("option", { value, textContent })));
  choice.setAttribute("aria-label", "What is shown");
  section.append(...names.length > 1 ? [choice] : [], place);
  show(0);
};

const draw = async section => {
  const library = (await WebAssembly.instantiate(bytes_of(at("library").textContent))).instance.exports;
  if (drawing.image) {
    choose(section, ["robot"], () => new RobotStage(section, library, drawing));
    offer(section, "values", text => live.set(text.split(" ").map(Number)));
    if (drawing.names) offer(section, "period", text => live.trajectory.go(+text));
    return;
  }
  const meshes = drawing.meshes.map((mesh, i) => opened(library, mesh, i));
  const views = [...drawing.pairs.map(pair => ({ name: `${meshes[pair.a].name} and ${pair.a === pair.b ? "itself" : meshes[pair.b].name}`,
    make: () => new PairStage(section, library, meshes, pair) })),
  ...meshes.map(mesh => ({ name: `${mesh.name} alone`, make: () => new MeshStage(section, mesh) }))];
  choose(section, views.map(({ name }) => name), i => views[i].make());
};
if (drawing) {
  const section = at("live");
  section.hidden = false;
  draw(section).catch(error => section.append(element("p", { className: "note", textContent: `It cannot be shown here: ${error.message}.` })));
}
