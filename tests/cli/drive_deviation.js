// Drives a page about deviations like a reader.
begin_driving(() => {
  const { deviation } = window;
  const size = deviation.view.size;
  const drawn = deviation.marks()[0].points.length / 6 / (deviation.coarse.length / 9);
  claim("triangles that face the reader are drawn as lines", drawn > 0.25 && drawn < 0.75);
  deviation.box.querySelector("button").click();
  claim("a button goes near the largest deviation", Math.abs(deviation.view.size / deviation.most - 24) < 1e-6 &&
    deviation.view.size < size / 2 && deviation.view.middle.every(part => part === 0));
  const choice = document.querySelector(".live>select");
  choice.value = 1;
  choice.dispatchEvent(new Event("change"));
  claim("another mesh is chosen", window.deviation !== deviation && window.deviation.name === "ring");
});
