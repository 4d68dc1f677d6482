// The data of the page: the world every so many milliseconds. Between two frames robots move evenly.

const CUPS = ["none", "empty", "full"];

class Recording {
  constructor(data) {
    this.world = data.world;
    this.frames = data.frames;
    this.events = data.events;
    this.period = data.period;
    this.length = this.frames.length === 0 ? 0 : this.frames[this.frames.length - 1].t;
  }

  /** The frame that shows a moment: the last one before it. */
  index(time) {
    return clamp(Math.floor(time / this.period), 0, this.frames.length - 1);
  }

  /** A robot at a moment. */
  robot(number, time) {
    const index = this.index(time);
    const here = Recording.parts(this.frames[index].robots[number]);
    const next = this.frames[index + 1];
    if (next === undefined) {
      return here;
    }
    const there = Recording.parts(next.robots[number]);
    const share = clamp((time - this.frames[index].t) / this.period, 0, 1);
    for (const key of ["x", "y", "heading"]) {
      here[key] += (there[key] - here[key]) * share;
    }
    return here;
  }

  static parts(robot) {
    const [x, y, heading, left, right, cup, readings, display, stock, isBrewing] = robot;
    return { x, y, heading, left, right, cup: CUPS[cup], readings, display, stock, isBrewing };
  }

  drinker(number, time) {
    const [isPresent, cups] = this.frames[this.index(time)].drinkers[number];
    return { isPresent, cups };
  }

  /** Where a robot was during the seconds before a moment: x, y, x, y. */
  trail(number, time, seconds) {
    const last = this.index(time);
    const first = Math.max(0, last - Math.round((1000 * seconds) / this.period));
    const points = [];
    for (let i = first; i <= last; i++) {
      const robot = this.frames[i].robots[number];
      points.push([robot[0], robot[1]]);
    }
    return points;
  }
}
