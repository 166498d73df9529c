// Drives a robot's page like a reader, and reports claims. The trajectory begins free, ends in a
// stop.
const drive_trajectory = async () => {
  const { trajectory } = live;
  claim("the time line has a period a line", trajectory.verdicts.length === 101);
  trajectory.play.click();
  await wait();
  claim("it plays", trajectory.period > 0 && trajectory.place.value === `${trajectory.period}`);
  trajectory.play.click();
  const { period } = trajectory;
  await wait();
  claim("and halts", trajectory.period === period);
  // A period's verdict covers the motion to its values, too; the last one is that of these values.
  const stop = trajectory.verdicts.indexOf("3");
  trajectory.place.value = 100;
  trajectory.place.dispatchEvent(new Event("input"));
  claim("a period that stops stops here, too", trajectory.name.textContent.includes("stops on the way") &&
    live.section.dataset.verdict === "3");
  claim("before the first it does not", (trajectory.go(stop - 1), live.section.dataset.verdict !== "3"));
  key([...document.querySelectorAll("[data-period]")].find(line => line.dataset.period === `${stop}`), "Enter");
  claim("a line of a table opens its period", trajectory.period === stop);
};

const drive_robot = async () => {
  const { arm } = live;
  claim("the section is shown", !live.section.hidden);
  const moved = arm.links.findLastIndex(({ whole, variable }, i) => whole === i && variable < arm.variables.length && seen(i));
  const [x, y] = seen(moved);
  const { variable } = arm.links[moved];
  const before = arm.values[variable];
  drag(x, y, 30, 30);
  claim("a link that is dragged moves its joint", Math.abs(arm.values[variable] - before) > 0.02);
  await wait();
  claim("its slider follows", Math.abs(live.sliders[variable].range.value - arm.values[variable]) < 1e-6);

  const { range } = live.sliders[0];
  range.value = (arm.variables[0].lower + 3 * arm.variables[0].upper) / 4;
  range.dispatchEvent(new Event("input"));
  claim("a slider moves its joint", Math.abs(arm.values[0] - range.value) < 1e-6 && arm.values[0] !== 0);

  // The middle of a zone is visible where the middle of its outline is.
  const [zone] = live.marks();
  const middle = [0, 1, 2].map(i => zone.points.reduce((sum, point) => sum + point[i], 0) / zone.points.length);
  claim("a joint zone is drawn about its joint", arm.zones.length > 0 && zone.points.length === 64 &&
    middle.every((part, i) => Math.abs(part - arm.balls[0].middle[i]) < 1e-6) &&
    Math.abs(Math.hypot(...zone.points[0].map((part, i) => part - middle[i])) - arm.zones[0][4]) < 1e-6);
  const { yaw } = live.view.turn;
  key(live.canvas, "ArrowLeft");
  claim("a key turns the robot", live.view.turn.yaw !== yaw);

  const cell = document.querySelector("[data-values]");
  key(cell, "Enter");
  const shown = cell.dataset.values.split(" ").map(Number);
  claim("a cell of the matrix shows its collision", arm.values.every((value, i) => Math.abs(value - shown[i]) < 1e-6));
  claim("there it stops", live.section.dataset.verdict === "3" && live.says.textContent.startsWith("stops"));

  live.set_all(arm.variables.map(({ lower, upper }) => Math.min(Math.max(0, lower), upper)));
  const free = live.section.dataset.verdict;
  const [stop] = document.querySelectorAll(".distances input");
  stop.value = 1000 * live.answer.nearest.metres + 100;
  stop.dispatchEvent(new Event("change"));
  claim("a larger stop stops", free !== "3" && live.section.dataset.verdict === "3");
  claim("and says what is not looked at", live.says.textContent.includes("not looked at"));
  await wait();
  arm.library.open(Uint8Array.from(atob(JSON.parse(document.getElementById("live-data").textContent).image), c => c.charCodeAt(0)).length);
  claim("all answers are the guard's", wrong_answer(arm.library) === undefined);
};
begin_driving(() => (live.trajectory ? drive_trajectory() : drive_robot()));
