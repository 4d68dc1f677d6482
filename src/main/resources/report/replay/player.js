// Plays, pauses, goes to a moment.

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16];

class Player {
  constructor(recording, show) {
    this.recording = recording;
    this.show = show;
    this.time = 0;
    this.isPlaying = false;
    this.speed = 1;
    this.play = button("Play", "Play or pause (space)", () => this.toggle(), { id: "play" });
    this.slider = element("input", {
      type: "range",
      id: "moment",
      min: 0,
      max: recording.length,
      step: recording.period,
      value: 0,
      "aria-label": "Moment",
      oninput: () => this.go(Number(this.slider.value)),
    });
    this.slide = element("span", { class: "slide" }, marks(recording), this.slider);
    this.clock = element("span", { class: "time", id: "clock" });
    this.chooser = element(
      "select",
      { id: "speed", "aria-label": "Speed", onchange: () => this.setSpeed(Number(this.chooser.value)) },
      ...SPEEDS.map((speed) => element("option", { value: speed, selected: speed === 1 }, speed + " x")),
    );
  }

  elements() {
    return [this.play, this.slide, this.clock, this.chooser];
  }

  toggle() {
    this.isPlaying = !this.isPlaying;
    this.play.textContent = this.isPlaying ? "Pause" : "Play";
    if (this.isPlaying) {
      if (this.time >= this.recording.length) {
        this.go(0);
      }
      this.before = null;
      requestAnimationFrame((now) => this.tick(now));
    }
  }

  tick(now) {
    if (!this.isPlaying) {
      return;
    }
    const passed = this.before === null ? 0 : now - this.before;
    this.before = now;
    this.go(this.time + passed * this.speed);
    if (this.time >= this.recording.length) {
      this.toggle();
    } else {
      requestAnimationFrame((later) => this.tick(later));
    }
  }

  go(time) {
    this.time = clamp(time, 0, this.recording.length);
    this.slider.value = this.time;
    this.clock.textContent = seconds(this.time) + " of " + seconds(this.recording.length);
    this.show(this.time);
  }

  /** What a screen reader says of the moment, besides its time. */
  tell(words) {
    const text = this.clock.textContent + (words === "" ? "" : ": " + words);
    if (text !== this.told) {
      this.told = text;
      this.slider.setAttribute("aria-valuetext", text);
    }
  }

  setSpeed(speed) {
    this.speed = speed;
    this.chooser.value = String(speed);
  }

  faster(steps) {
    this.setSpeed(SPEEDS[clamp(SPEEDS.indexOf(this.speed) + steps, 0, SPEEDS.length - 1)]);
  }
}

/** When something happened, above the slider; what went wrong stands out. */
function marks({ events, length }) {
  const at = (event) => (100 * event.t) / Math.max(1, length) + "%";
  const lines = events.map((event) => shape("line", { class: BAD.has(event.what) ? "bad" : null, x1: at(event), x2: at(event), y1: 0, y2: 8 }));
  return shape("svg", { class: "marks", width: "100%", height: 8, "aria-hidden": "true" }, ...lines);
}
