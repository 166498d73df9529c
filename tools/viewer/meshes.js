// The page's section: the reader chooses a pair of meshes or a single mesh.
begin("live", async (section, data) => {
  const meshes = await Meshes.from(data);
  const views = [...data.pairs, ...meshes.all.map((_, a) => ({ a }))];
  const name = ({ a, b }) => meshes.all[a].name + (b === undefined ? " alone" : a === b ? " and itself" : ` and ${meshes.all[b].name}`);
  const show = choose(section, views.map(name), data.first, i => {
    const Shown = views[i].b === undefined ? RayStage : PairStage;
    window.live = new Shown(section, meshes, views[i]);
    return window.live;
  });
  offer(section, "values", (text, { pair }) => {
    show(+pair);
    window.live.set(text.split(" ").map(Number));
  });
});
