// A sequence of positions: a time line of their verdicts, under a slider, to click, to play and to step through.
class Trajectory {
  // `verdicts`: one digit per position; `show(i)` displays a position and returns its name and verdict.
  constructor(verdicts, what, show) {
    this.verdicts = verdicts;
    this.show = show;
    this.last = verdicts.length - 1;
    this.line = element("canvas", { className: "line", height: 1, width: Math.min(verdicts.length, 1000) });
    this.place = element("input", { type: "range", min: 0, max: this.last, value: 0 });
    this.place.setAttribute("aria-label", what);
    const button = (textContent, title, onclick) => element("button", { textContent, title, onclick });
    this.play = button("\u25B6", "Play", () => (this.timer ? this.#halt() : this.#run()));
    this.name = element("span");
    this.bar = element("div", { className: "trajectory" }, this.line, this.place, element("span", {},
      button("\u2212", "One back", () => this.go(this.period - 1)), this.play,
      button("+", "One on", () => this.go(this.period + 1))), this.name);
    this.place.oninput = () => this.go(+this.place.value);
  }

  // Draws the time line in the colours of the section, and shows the first position of the worst, if that is worse than a warning.
  attach(section) {
    const colours = [0, 1, 2, 3, 4, 5].map(i => getComputedStyle(section).getPropertyValue(`--v${i}`));
    const pen = this.line.getContext("2d");
    const { width } = this.line;
    for (let x = 0; x < width; ++x) {
      const [from, to] = [x, x + 1].map(end => Math.floor(end * this.verdicts.length / width));
      pen.fillStyle = colours[Math.max(...this.verdicts.slice(from, Math.max(to, from + 1)))];
      pen.fillRect(x, 0, 1, 1);
    }
    this.go([5, 4, 3, 2].map(verdict => this.verdicts.indexOf(verdict)).find(i => i >= 0) ?? 0);
  }

  go(period) {
    this.period = Math.min(Math.max(period, 0), this.last);
    this.place.value = this.period;
    this.name.textContent = this.show(this.period);
  }

  // Plays all positions in ten seconds, or one position per frame.
  #run() {
    if (this.period === this.last) this.go(0);
    const step = Math.max(1, Math.round(this.verdicts.length / 300));
    this.play.textContent = "\u275A\u275A";
    this.timer = setInterval(() => {
      this.go(this.period + step);
      if (this.period === this.last || !this.bar.isConnected) this.#halt();
    }, 33);
  }
  #halt() {
    clearInterval(this.timer);
    this.timer = 0;
    this.play.textContent = "\u25B6";
  }
}
