// A trajectory: its verdicts as a time line, which is played.
class Trajectory {
  constructor({ values, verdicts, names }) {
    this.values = new Float32Array(bytes_of(values).buffer);
    this.verdicts = verdicts;
    this.names = names;
    this.line = element("canvas", { className: "line", height: 1, width: Math.min(names.length, 1000) });
    this.place = element("input", { type: "range", min: 0, max: names.length - 1, value: 0 });
    this.place.setAttribute("aria-label", "Period");
    this.play = element("button", { textContent: "\u25B6", title: "Play" });
    this.name = element("span", {});
    this.bar = element("div", { className: "trajectory" }, this.line, this.place, this.play, this.name);
    this.place.oninput = () => this.go(+this.place.value);
    this.play.onclick = () => (this.timer ? this.#halt() : this.#run());
  }

  attach(live) {
    this.live = live;
    const colours = VERDICTS.map((_, i) => getComputedStyle(live.section).getPropertyValue(`--v${i}`));
    const pen = this.line.getContext("2d");
    const { width } = this.line;
    for (let x = 0; x < width; ++x) {
      const [from, to] = [x, x + 1].map(end => Math.floor(end * this.names.length / width));
      pen.fillStyle = colours[Math.max(...this.verdicts.slice(from, Math.max(to, from + 1)))];
      pen.fillRect(x, 0, 1, 1);
    }
    this.go(0);
  }

  go(period) {
    this.period = Math.min(period, this.names.length - 1);
    this.place.value = this.period;
    const count = this.live.arm.variables.length;
    this.live.set_all([...this.values.slice(count * this.period, count * (this.period + 1))]);
    this.name.textContent = `${this.names[this.period]}: ${VERDICTS[this.verdicts[this.period]]} on the way`;
  }

  // All of it in ten seconds, or a period a frame.
  #run() {
    if (this.period === this.names.length - 1) this.go(0);
    const step = Math.max(1, Math.round(this.names.length / 300));
    this.play.textContent = "\u275A\u275A";
    this.timer = setInterval(() => {
      this.go(this.period + step);
      if (this.period === this.names.length - 1) this.#halt();
    }, 33);
  }
  #halt() {
    clearInterval(this.timer);
    this.timer = 0;
    this.play.textContent = "\u25B6";
  }
}
