// Drives a page like a reader; its value is claims.
const wait = () => new Promise(resolve => { setTimeout(resolve, 200); });
const claims = [];
const claim = (what, holds) => claims.push(`${what}: ${holds}`);
const verdict = () => live.section.dataset.verdict;
const says = text => live.says.textContent.includes(text);

const change = (input, value, kind = "change") => {
  input.value = value;
  input.dispatchEvent(new Event(kind));
};
const pointer = (kind, x, y, pointerId = 1) => {
  const at = live.canvas.getBoundingClientRect();
  live.canvas.dispatchEvent(new PointerEvent(kind, {
    pointerId, clientX: at.left + live.canvas.clientLeft + x, clientY: at.top + live.canvas.clientTop + y, bubbles: true }));
};
const drag = (x, y, right, down) => {
  pointer("pointerdown", x, y);
  for (let step = 1; step <= 5; ++step) pointer("pointermove", x + right * step / 5, y + down * step / 5);
  pointer("pointerup", x + right, y + down);
};
const key = (target, name) => target.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true }));

// A pixel that shows a link or a mesh, away from its edge; or undefined.
const seen = part => {
  const { clientWidth, clientHeight } = live.canvas;
  for (let y = 10; y < clientHeight; y += 12) {
    for (let x = 10; x < clientWidth; x += 12) {
      if ([0, 4].every(more => live.view.pick(live.matrices(), x + more, y + more) === part)) return [x + 2, y + 2];
    }
  }
};

const press = name => [...document.querySelectorAll(".buttons button")].find(({ textContent }) => textContent === name).click();

const drive_view = () => {
  const { yaw } = live.view.turn;
  key(live.canvas, "ArrowLeft");
  claim("a key turns the view", live.view.turn.yaw !== yaw);
  const { distance } = live.view;
  pointer("pointerdown", 10, 10);
  pointer("pointerdown", 60, 10, 2);
  pointer("pointermove", 110, 10, 2);
  pointer("pointerup", 10, 10);
  pointer("pointerup", 110, 10, 2);
  claim("two fingers come nearer", Math.abs(live.view.distance / distance - 0.5) < 1e-6);
  press("First view");
  claim("a button shows the first view", live.view.turn.yaw === yaw && live.view.distance === distance);
};

const drive_trajectory = async () => {
  const { trajectory } = live;
  const last = trajectory.verdicts.length - 1;
  trajectory.play.click();
  await wait();
  claim("it plays", trajectory.period > 0 && trajectory.place.value === `${trajectory.period}`);
  trajectory.play.click();
  const { period } = trajectory;
  await wait();
  claim("and halts", trajectory.period === period);
  change(trajectory.place, last, "input");
  claim("its slider shows a position", trajectory.period === last);
  trajectory.bar.querySelector("[title='One back']").click();
  claim("a button steps", trajectory.period === last - 1);
};

// The trajectory begins free, and ends in a stop.
const drive_way = async () => {
  await drive_trajectory();
  const { trajectory } = live;
  claim("the time line has a period a line", trajectory.verdicts.length === 101);
  // A period's verdict covers the motion to its values, too; the last one is that of these values.
  trajectory.go(100);
  claim("a period that stops stops here, too", trajectory.name.textContent.includes("stops on the way") && verdict() === "4");
  const stop = trajectory.verdicts.indexOf("4");
  trajectory.go(stop - 1);
  claim("before the first it does not", verdict() !== "4");
  key([...document.querySelectorAll("[data-period]")].find(line => line.dataset.period === `${stop}`), "Enter");
  claim("a line of a table opens its period", trajectory.period === stop);
};

const drive_robot = async () => {
  const { links, variables, sliders } = live;
  const moved = links.findLastIndex(({ whole, variable }, i) => whole === i && variable < variables.length && seen(i));
  const { variable } = links[moved];
  const before = live.values[variable];
  drag(...seen(moved), 45, -30);
  claim("a link that is dragged moves its joint", Math.abs(live.values[variable] - before) > 0.02);
  claim("its slider follows", Math.abs(sliders[variable].range.value - live.values[variable]) < 1e-6);
  change(sliders[0].range, (variables[0].lower + 3 * variables[0].upper) / 4, "input");
  claim("a slider moves its joint", Math.abs(live.values[0] - sliders[0].range.value) < 1e-6 && live.values[0] !== 0);

  // The middle of a zone is visible where the middle of its outline is.
  const [zone] = live.marks();
  const middle = [0, 1, 2].map(i => zone.points.reduce((sum, point) => sum + point[i], 0) / zone.points.length);
  claim("a joint zone is drawn about its joint", live.zones.length > 0 && zone.points.length === 64 &&
    middle.every((part, i) => Math.abs(part - live.balls[0].middle[i]) < 1e-6) &&
    Math.abs(Math.hypot(...zone.points[0].map((part, i) => part - middle[i])) - live.zones[0][4]) < 1e-6);

  const cell = document.querySelector("[data-values]");
  key(cell, "Enter");
  const shown = cell.dataset.values.split(" ").map(Number);
  claim("a cell of the matrix shows its collision", live.values.every((value, i) => Math.abs(value - shown[i]) < 1e-6));
  claim("there it stops", verdict() === "4" && says("stops"));
  const said = live.says.textContent.match(/[a-z]+_?[a-z]*(?= \u2013)/g);
  claim("each pair is named once", new Set(said).size === said.length);
  press("Free pose");
  claim("a button frees it", verdict() === "0");
  drive_view();
};

const drive_slides = () => {
  const [slider] = live.sliders;
  change(slider.number, 12.34567);
  claim("a slide is in mm with three digits", slider.row.textContent.endsWith("mm") && slider.number.value === "12.346" &&
    Math.abs(live.values[0] - 0.01234567) < 1e-9);
  live.set([0.6, 0.3]);
  const { metres, links } = live.answer.nearest;
  const at = live.library.nearest_links(live.links.length);
  claim("parts of neighbours are nearer", new Float64Array(live.library.memory.buffer, at, 1)[0] < metres);
  claim("but not named", links.every(i => live.links[i].whole === i) && !says("table \u2013 bridge"));
};

const drive_pair = async () => {
  await drive_trajectory();
  const { trajectory } = live;
  claim("a pose a place of the time line", trajectory.verdicts.length === 105);
  claim("each with the verdict that it has here", [...trajectory.verdicts].every((digit, i) => {
    trajectory.go(i);
    return verdict() === digit;
  }));
  claim("each with the way there", /; the straight way there (is free|touches|comes)/.test(trajectory.name.textContent));
  trajectory.go(trajectory.verdicts.indexOf("4"));
  press("Free pose");
  claim("a button frees B", verdict() === "0");
  change(live.text, "1 0 0 0 1 0 0 0 1 0 0 100");
  claim("numbers are a pose", live.pose[11] === 100 && verdict() === "0" && says("does not touch"));
  change(live.sliders[2].range, 12, "input");
  claim("a slider moves B", live.pose[11] === 12 && live.text.value.endsWith(" 12"));
  change(live.sliders[5].number, 90);
  claim("a number turns it", Math.abs(live.pose[3] - 1) < 1e-9 && Math.abs(live.six[5] - Math.PI / 2) < 1e-9);
  const pixel = () => live.view.pixel(live.matrices()[1].slice(12, 15));
  const turned = live.pose.slice(0, 9).join();
  const before = pixel();
  drag(...seen(1), 40, 0);
  claim("B follows the pointer, and does not turn", Math.abs(pixel()[0] - before[0] - 40) < 1 &&
    Math.abs(pixel()[1] - before[1]) < 1 && live.pose.slice(0, 9).join() === turned);
  change(live.text, "1 0 0 0 1 0 0 0 2 0 0 0");
  claim("what is no rotation is refused", verdict() === "5");
  drive_view();
  const choice = document.querySelector("#live select");
  trajectory.play.click();
  change(choice, choice.options.length - 2);
  claim("a mesh is shown alone", live.mesh.name === "ring" && says("400 triangles"));
  await wait();
  claim("what is not shown any more halts", trajectory.timer === 0);
};

(async () => {
  await wait();
  claim("the section is shown", !live.section.hidden);
  await (live.pose ? drive_pair() : live.trajectory ? drive_way() : live.variables[0].slides ? drive_slides() : drive_robot());
  return claims;
})();
