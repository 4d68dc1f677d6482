// The part of a run that is to be seen: from which step, how many steps, on how many pixels.

const FEWEST_STEPS = 4;

/** Pixels for a step. */
const EASY_TO_READ = 36;
const STILL_TO_READ = 20;

class View {
  constructor(length) {
    this.length = Math.max(1, length);
    this.from = 0;
    this.span = this.length;
    this.width = 800;
    this.abbreviates = true;
  }

  get pixelsPerStep() {
    return this.width / this.span;
  }

  x(step) {
    return (step - this.from) * this.pixelsPerStep;
  }

  /** The step at a place, within the run. */
  step(x) {
    return clamp(Math.floor(this.from + x / this.pixelsPerStep), 0, this.length - 1);
  }

  show(from, span) {
    this.span = clamp(span, Math.min(FEWEST_STEPS, this.length), this.length);
    this.from = clamp(from, 0, this.length - this.span);
  }

  showAll() {
    this.show(0, this.length);
  }

  /** All of it, or if that is too much to read, the surroundings of a step. */
  showWell(step) {
    if (this.width / this.length >= STILL_TO_READ) {
      this.showAll();
      return;
    }
    const readable = this.width / EASY_TO_READ;
    this.show(step - readable / 3, Math.max(FEWEST_STEPS, readable));
  }

  /** A step stays where it is while all around it grows or shrinks. */
  zoom(factor, step) {
    const share = (step + 0.5 - this.from) / this.span;
    const span = clamp(this.span / factor, Math.min(FEWEST_STEPS, this.length), this.length);
    this.show(step + 0.5 - share * span, span);
  }

  pan(steps) {
    this.show(this.from + steps, this.span);
  }

  /** Moves as little as needed to show a step with some room around it. */
  reveal(step) {
    const room = Math.min(this.span / 4, 3);
    if (step < this.from + room) {
      this.show(step - room - (step < this.from ? this.span / 3 : 0), this.span);
    } else if (step + 1 > this.from + this.span - room) {
      const far = step > this.from + this.span ? this.span / 3 : 0;
      this.show(step + 1 + room + far - this.span, this.span);
    }
  }
}
