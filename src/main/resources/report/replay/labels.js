// Where names of robots stand: beside their robot, where they cover nothing else, and no other name.

/** Widths of letters in mm, as wide as they are drawn; on the safe side. */
const NAME_LETTER = 34;
const DOING_LETTER = 29;
const LABEL_HEIGHT = 66;

/** From the one that is liked best: how a label lies to a robot with this radius. */
const SIDES = [
  { anchor: "middle", dx: () => 0, dy: (radius) => -radius - 24 },
  { anchor: "middle", dx: () => 0, dy: (radius, letters) => radius + 8 + 62 * letters },
  { anchor: "start", dx: (radius) => radius + 24, dy: () => 20 },
  { anchor: "end", dx: (radius) => -radius - 24, dy: () => 20 },
];

class Labels {
  /** @param width and depth of the floor, which labels do not leave without need */
  constructor({ width, depth }, obstacles) {
    this.floor = { x: 0, y: 0, width, height: depth };
    this.obstacles = obstacles;
    this.chosen = new Map();
  }

  /**
   * Places the labels of robots, one after the other.
   *
   * @param robots { text, name, doing, x, y, radius }
   * @param letters how much larger they are than usual
   */
  place(robots, letters) {
    const taken = [...this.obstacles, ...robots.map((robot) => around(robot.x, robot.y, robot.radius))];
    robots.forEach((robot, number) => {
      const places = SIDES.map((side) => ({ side, box: labelBox(robot, side, letters) }));
      const costs = places.map(({ box }) => taken.reduce((sum, other) => sum + overlap(box, other), 0) + outside(box, this.floor));
      // Where it stands as well as anywhere, it stays: a label that jumps cannot be read.
      const before = this.chosen.get(number);
      const best = costs.indexOf(Math.min(...costs));
      const choice = before !== undefined && costs[before] <= costs[best] ? before : best;
      this.chosen.set(number, choice);
      taken.push(places[choice].box);
      write(robot, places[choice].side, letters);
    });
  }
}

function write(robot, side, letters) {
  robot.text.setAttribute("x", robot.x + side.dx(robot.radius));
  robot.text.setAttribute("y", robot.y + side.dy(robot.radius, letters));
  robot.text.style.textAnchor = side.anchor;
}

function labelBox(robot, side, letters) {
  const width = letters * (NAME_LETTER * robot.name.length + DOING_LETTER * (robot.doing.length + 1));
  const height = letters * LABEL_HEIGHT;
  const x = robot.x + side.dx(robot.radius);
  const from = side.anchor === "middle" ? x - width / 2 : side.anchor === "start" ? x : x - width;
  return { x: from, y: robot.y + side.dy(robot.radius, letters) - height + 12, width, height };
}

function around(x, y, radius) {
  return { x: x - radius, y: y - radius, width: 2 * radius, height: 2 * radius };
}

/** How much of two boxes is the same place. */
function overlap(one, other) {
  const across = Math.min(one.x + one.width, other.x + other.width) - Math.max(one.x, other.x);
  const down = Math.min(one.y + one.height, other.y + other.height) - Math.max(one.y, other.y);
  return across > 0 && down > 0 ? across * down : 0;
}

function outside(box, floor) {
  return box.width * box.height - overlap(box, floor);
}
