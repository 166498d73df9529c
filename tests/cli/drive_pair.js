// Drives a page of two meshes like a reader.
const verdict = () => live.section.dataset.verdict;
const change = (input, value, kind = "change") => {
  input.value = value;
  input.dispatchEvent(new Event(kind));
};

const same = (p, q) => p.length === q.length && p.every((part, i) => Math.abs(part - q[i]) < 1e-9);
// The pixel of B's middle.
const middle = () => {
  const [x, y, z] = live.meshes.all[1].middle;
  return live.view.pixel([0, 1, 2].map(i => live.matrix[i] * x + live.matrix[4 + i] * y + live.matrix[8 + i] * z + live.matrix[12 + i]));
};

const drive_pair = async () => {
  const { trajectory } = live;
  claim("a pose a place of the time line", trajectory.verdicts.length === 105 && trajectory.period === 0);
  claim("each with the verdict that it has here", [...trajectory.verdicts].every((digit, i) => {
    trajectory.go(i);
    return verdict() === digit;
  }));
  trajectory.go(0);
  trajectory.bar.querySelector("[title='One on']").click();
  claim("each with the way there", trajectory.name.textContent.includes("; the straight way there ") &&
    ["free", "touches", "comes"].some(word => trajectory.name.textContent.includes(word)));
  claim("a button steps on", trajectory.period === 1 && trajectory.name.textContent.startsWith("pose 1: "));

  change(live.field.text, "1 0 0 0 1 0 0 0 1 0 0 100");
  await wait();
  claim("numbers are a pose", live.pose[11] === 100 && verdict() === "0" && live.says.textContent.includes("does not touch"));
  live.field.row.querySelector("button").click();
  claim("a button copies them", live.field.text.selectionEnd === live.field.text.value.length &&
    live.field.text.value.split(" ").length === 12);
  live.field.text.blur();
  const { distance } = live.answer;
  change(live.limit_input, distance + 1);
  claim("a limit above the distance is said to hold", verdict() === "1" && live.says.textContent.includes("; closer than"));
  change(live.limit_input, distance - 1);
  claim("one below it is not", verdict() === "0" && live.says.textContent.includes("not closer"));
  change(live.sliders[2].range, 12, "input");
  claim("a slider moves B", live.pose[11] === 12);
  change(live.sliders[5].number, 90);
  claim("a number turns it", Math.abs(live.pose[3] - 1) < 1e-9 && Math.abs(live.six[5] - Math.PI / 2) < 1e-9);

  const [x, y] = seen(1);
  let before = [...live.pose];
  drag(x, y, 40, 0);
  const pixel = middle();
  claim("dragged, B moves and does not turn", same(before.slice(0, 9), live.pose.slice(0, 9)) && !same(before, live.pose));
  drag(x + 40, y, -40, 0);
  const back = middle();
  claim("as far as the pointer does", Math.abs(pixel[0] - back[0] - 40) < 1 && Math.abs(pixel[1] - back[1]) < 1);
  before = [...live.pose];
  drag(x, y, 40, 10, { shiftKey: true });
  const after = middle();
  claim("with Shift it turns about its middle", !same(before.slice(0, 9), live.pose.slice(0, 9)) &&
    Math.hypot(after[0] - back[0], after[1] - back[1]) < 1);
  before = [...live.pose];
  key(live.canvas, "ArrowLeft");
  claim("an arrow key moves it", !same(before, live.pose));
  key(live.canvas, "ArrowRight");
  claim("and back", same(before, live.pose));
  key(live.canvas, "ArrowLeft", { shiftKey: true });
  claim("with Shift a key turns it", Math.abs(before[0] - live.pose[0]) > 1e-4);
  const { yaw } = live.view.turn;
  key(live.canvas, "ArrowLeft", { altKey: true });
  claim("with Alt the view", live.view.turn.yaw !== yaw);
  const { distance: far } = live.view;
  pointer("pointerdown", x, y);
  pointer("pointerdown", x + 50, y, { pointerId: 2 });
  pointer("pointermove", x + 100, y, { pointerId: 2 });
  pointer("pointerup", x, y);
  pointer("pointerup", x + 100, y, { pointerId: 2 });
  claim("two fingers come nearer", Math.abs(live.view.distance / far - 0.5) < 1e-6);
  for (let i = 0; i < 200; ++i) key(live.canvas, "ArrowLeft", { shiftKey: true });
  claim("many turns leave a rotation", live.status === 0);
  change(live.field.text, "1 0 0 0 1 0 0 0 2 0 0 0");
  claim("what is no rotation is refused", verdict() === "4");
};

const drive_ray = async () => {
  const before = live;
  before.trajectory.play.click();
  const choice = document.querySelector("#live>select");
  change(choice, choice.options.length - 2);
  claim("a mesh is shown alone", live.name === "ring");
  await wait();
  claim("what is not shown any more halts", before.trajectory.timer === 0 && verdict() === "0");
  const [x, y] = seen(0);
  drag(x, y, 0, 0);
  const { triangle } = live.hit;
  claim("a click hits a triangle", live.says.textContent.startsWith(`The ray hits triangle ${triangle}`));
  claim("at the pixel that was clicked", Math.hypot(...live.view.pixel(live.hit.point).map((at, i) => at - [x, y][i])) < 1);
  const text = live.field.text.value;
  change(live.field.text, text);
  claim("its numbers are a ray", live.hit.triangle === triangle && live.field.text.value === text);
  change(live.field.text, "0 0 100 0 0 -100");
  claim("through a ring there is nothing to hit", live.says.textContent === "The ray hits nothing");
};

begin_driving(async () => {
  await drive_pair();
  await drive_ray();
  claim("all answers are the firmware's", wrong_answer(live.meshes.library) === undefined);
});
