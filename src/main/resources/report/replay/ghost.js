// Another run on the same floor, at the same moment: of another seed, or of another version of the programs.

/** So far apart, in mm, two runs are no longer the same to the eye. */
const APART = 5;

class Ghost {
  constructor(floor, recording) {
    this.floor = floor;
    this.data = recording.ghost;
    const radius = (name) => recording.world.robots.find((robot) => robot.name === name)?.radius || 80;
    this.robots = this.data.robots.map((name) => {
      const r = radius(name);
      const nose = shape("path", { class: "nose", d: `M${0.35 * r} ${-0.35 * r}L${0.85 * r} 0L${0.35 * r} ${0.35 * r}` });
      return shape("g", { class: "ghost" }, shape("title", {}, `${name} in ${this.data.label}`), shape("circle", { class: "body", r }), nose);
    });
    this.note = element("p", { class: "ghost-note" }, `dashed: ${this.data.label}; ${this.parting(recording)}`);
  }

  /** Where a robot is at a moment: x, y, heading; where the run is over, as at its end. */
  at(number, time) {
    const { frames, period } = this.data;
    const index = clamp(Math.floor(time / period), 0, frames.length - 1);
    const here = frames[index][number];
    const next = (frames[index + 1] || frames[index])[number];
    const share = clamp(time / period - index, 0, 1);
    return here.map((value, each) => value + (next[each] - value) * share);
  }

  /** From when on a robot is somewhere else. */
  parting(recording) {
    const names = recording.world.robots.map((robot) => robot.name);
    const pairs = this.data.robots.map((name, ghost) => ({ ghost, own: names.indexOf(name) })).filter(({ own }) => own >= 0);
    const isApart = (frame) =>
      pairs.some(({ ghost, own }) => {
        const [x, y] = this.at(ghost, frame.t);
        return Math.hypot(frame.robots[own][0] - x, frame.robots[own][1] - y) > APART;
      });
    const first = recording.frames.find(isApart);
    return first === undefined ? "all go the same way" : `they part at ${seconds(first.t)}`;
  }

  show(time) {
    this.robots.forEach((robot, number) => {
      const [x, y, heading] = this.at(number, time);
      robot.setAttribute("transform", `translate(${x} ${this.floor.y(y)}) rotate(${-heading})`);
    });
  }
}
