// Drives a page like a reader, and reports claims; shared by the pages' own scripts.
const wait = () => new Promise(resolve => { setTimeout(resolve, 200); });
const claim = (what, holds) => claims.push(`${what}: ${holds}`);
const claims = [];

const pointer = (kind, x, y, more = {}) => {
  const at = live.canvas.getBoundingClientRect();
  live.canvas.dispatchEvent(new PointerEvent(kind, {
    pointerId: 1, clientX: at.left + live.canvas.clientLeft + x, clientY: at.top + live.canvas.clientTop + y, bubbles: true, ...more }));
};
const drag = (x, y, right, down, more) => {
  pointer("pointerdown", x, y, more);
  for (let step = 1; step <= 5; ++step) pointer("pointermove", x + right * step / 5, y + down * step / 5, more);
  pointer("pointerup", x + right, y + down, more);
};
const key = (target, name, more = {}) => target.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, ...more }));

// A pixel that shows a link or a mesh, away from its edge; or undefined.
const seen = part => {
  const { clientWidth, clientHeight } = live.canvas;
  for (let y = 10; y < clientHeight; y += 12) {
    for (let x = 10; x < clientWidth; x += 12) {
      if ([0, 4].every(more => live.view.pick(live.matrices(), x + more, y + more) === part)) return [x + 2, y + 2];
    }
  }
};

// `drive` makes the claims, which then replace the page's content.
const begin_driving = drive => addEventListener("load", async () => {
  try {
    await wait();
    await drive();
  } catch (error) {
    claims.push(`error: ${error.stack}`);
  }
  document.body.innerHTML = claims.map(text => `<p>claim ${text}</p>`).join("\n");
});
