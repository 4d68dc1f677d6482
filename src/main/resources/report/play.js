// Plays a run: a step after another, as fast as it is told.

/** Steps in a second. */
const STEPS_A_SECOND = [1, 2, 4, 8, 16];
const USUAL_SPEED = 4;

class Play {
  constructor(story) {
    this.story = story;
    this.timer = null;
    this.button = button("Play", "Play or pause (space)", () => this.toggle(), { id: "play" });
    this.speed = element(
      "select",
      { id: "speed", "aria-label": "Speed" },
      ...STEPS_A_SECOND.map((speed) => element("option", { value: speed, selected: speed === USUAL_SPEED }, `${speed} a second`)),
    );
    this.elements = [this.button, this.speed];
  }

  toggle() {
    if (this.timer !== null) {
      this.stop();
      return;
    }
    if (this.isAtEnd()) {
      this.story.go(0);
    }
    this.button.textContent = "Pause";
    this.wait();
  }

  wait() {
    this.timer = setTimeout(() => this.step(), 1000 / Number(this.speed.value));
  }

  /** Ends with the run, and where another run has taken its place. */
  step() {
    if (!this.button.isConnected || this.isAtEnd()) {
      this.stop();
      return;
    }
    this.story.go(this.story.cursor + 1);
    this.wait();
  }

  stop() {
    clearTimeout(this.timer);
    this.timer = null;
    this.button.textContent = "Play";
  }

  isAtEnd() {
    return this.story.cursor >= this.story.length - 1;
  }
}
