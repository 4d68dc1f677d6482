// The data of the page: the world every so many milliseconds. Between two frames robots move evenly.

const CUPS = ["none", "empty", "full"];

class Recording {
  constructor(data) {
    this.world = data.world;
    this.frames = data.frames;
    this.events = data.events;
    this.period = data.period;
    this.idling = data.idle;
    this.ghost = data.ghost;
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

  /** What the parts of a robot wait for at a moment: their paths and the reasons. */
  idle(name, time) {
    if (this.idling === undefined) {
      return [];
    }
    return this.idling.parts
      .filter((each) => each.robot === name)
      .map((each) => ({ part: each.part, words: this.idling.texts[Recording.last(each.reasons, time)] ?? "" }))
      .filter((each) => each.words !== "");
  }

  /** The text that holds at a moment, of moments and texts in turn; -1 before the first. */
  static last(reasons, time) {
    let low = 0;
    let high = reasons.length / 2;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (reasons[2 * middle] <= time) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low === 0 ? -1 : reasons[2 * low - 1];
  }

  /** How far the wheels of a robot have rolled up to a moment, left and right, in mm. */
  rolled(number, time) {
    if (this.ways === undefined) {
      this.ways = this.world.robots.map((_, robot) => Recording.ways(this.frames, robot, this.period));
    }
    const index = this.index(time);
    const share = (time - this.frames[index].t) / 1000;
    const { left, right } = Recording.parts(this.frames[index].robots[number]);
    const [leftBefore, rightBefore] = this.ways[number][index];
    return [leftBefore + left * share, rightBefore + right * share];
  }

  static ways(frames, robot, period) {
    let left = 0;
    let right = 0;
    return frames.map((frame) => {
      const way = [left, right];
      const now = Recording.parts(frame.robots[robot]);
      left += (now.left * period) / 1000;
      right += (now.right * period) / 1000;
      return way;
    });
  }

  drinker(number, time) {
    const [isPresent, cups] = this.frames[this.index(time)].drinkers[number];
    return { isPresent, cups };
  }

  /** Where a thing lies at a moment. */
  thing(number, time) {
    const index = this.index(time);
    const here = this.frames[index].things[number];
    const there = (this.frames[index + 1] ?? this.frames[index]).things[number];
    const share = clamp((time - this.frames[index].t) / this.period, 0, 1);
    return { x: here[0] + (there[0] - here[0]) * share, y: here[1] + (there[1] - here[1]) * share };
  }

  /** Where a robot or a thing was during the seconds before a moment: places of [x, y]. */
  trail(kind, number, time, seconds) {
    const last = this.index(time);
    const first = Math.max(0, last - Math.round((1000 * seconds) / this.period));
    return this.frames.slice(first, last + 1).map((frame) => frame[kind][number]);
  }
}
