// The floor from above. The world's y grows upwards, that of pictures downwards.

const TRAIL_SECONDS = 12;
const CONE = 15;
const NO_ECHO = 255;
const SVG_MARGIN = 40;
const DRINKER_RADIUS = 100;
const CUP_RADIUS = 28;
const BRIGHT = 45;

/** Of names, in mm; and no smaller than that on the screen, in pixels. */
const LETTERS = 62;
const SMALLEST_LETTERS = 11;

class Floor {
  constructor(recording) {
    this.recording = recording;
    this.world = recording.world;
    this.svg = shape("svg", { class: "floor", role: "img", "aria-label": "The floor from above" });
    this.followed = -1;
    this.robots = this.world.robots.map((robot) => this.robot(robot));
    this.drinkers = this.world.drinkers.map((drinker) => this.drinker(drinker));
    this.things = (this.world.things ?? []).map((thing) => this.thing(thing));
    this.trails = [...this.robots, ...this.things].map(() => shape("polyline", { class: "trail" }));
    this.labels = new Labels(this.world, this.world.drinkers.map((drinker) => around(drinker.x, this.y(drinker.y), DRINKER_RADIUS)));
    this.ghost = recording.ghost === undefined ? null : new Ghost(this, recording);
    this.svg.append(
      shape("rect", { class: "ground", width: this.world.width, height: this.world.depth }),
      shape(
        "g",
        { class: "lines" },
        ...this.world.lines.map((line) => this.outline(line.points, { class: "line", "stroke-width": line.width })),
      ),
      ...this.world.walls.map((wall) => this.outline(wall, { class: "wall" })),
      this.scale(),
      ...this.trails,
      ...this.things.map((thing) => thing.group),
      ...this.drinkers.map((drinker) => drinker.group),
      ...(this.ghost === null ? [] : this.ghost.robots),
      ...this.robots.map((robot) => robot.group),
      ...[...this.robots, ...this.things].map((body) => body.label),
    );
    this.width = 0;
    new ResizeObserver(() => this.measure()).observe(this.svg);
    this.look();
  }

  measure() {
    this.width = this.svg.clientWidth;
    this.look();
  }

  y(up) {
    return this.world.depth - up;
  }

  /** A length that one can compare with, in the corner below. */
  scale() {
    const { width, depth } = this.world;
    const length = [100, 200, 500, 1000, 2000, 5000].filter((each) => each <= width / 4).pop() || 100;
    const [x, y] = [40, depth - 40];
    const bar = shape("path", { d: `M${x} ${y - 18}v18h${length}v-18` });
    const words = length < 1000 ? length / 10 + " cm" : length / 1000 + " m";
    return shape("g", { class: "scale" }, bar, shape("text", { x: x + length / 2, y: y - 22 }, words));
  }

  outline(points, properties) {
    const places = [];
    for (let i = 0; i < points.length; i += 2) {
      places.push(points[i] + "," + this.y(points[i + 1]));
    }
    return shape("polyline", { points: places.join(" "), ...properties });
  }

  /** Drawn around (0, 0) with the front to the right; then moved and turned as a whole. */
  robot(robot) {
    const r = robot.radius;
    const parts = { rays: [], eyes: [], mouths: [], ears: [] };
    robot.sensors.forEach((sensor, index) => {
      if (sensor.type === "ultrasonic") {
        parts.rays.push({ index, sensor, shape: shape("path", { class: "ray" }) });
        parts.ears.push(this.ears(sensor));
      } else if (sensor.type === "light") {
        parts.eyes.push({ index, shape: shape("circle", { class: "eye", cx: sensor.x, cy: -sensor.y, r: 9 }) });
      } else if (sensor.x !== undefined) {
        parts.mouths.push(shape("circle", { class: "mouth", cx: sensor.x, cy: -sensor.y, r: 60 }));
      }
    });
    const wheel = (y) => shape("rect", { class: "wheel", x: -0.35 * r, y: y - 10, width: 0.7 * r, height: 20, rx: 5 });
    const tread = (y) => shape("path", { class: "tread", d: `M${-0.33 * r} ${y}H${0.33 * r}` });
    const treads = [tread(-0.8 * r), tread(0.8 * r)];
    const cup = shape("circle", { class: "cup", r: CUP_RADIUS });
    const crash = shape("circle", { class: "collision", r: r + 25 });
    const driven = !robot.moves ? [] : [
      wheel(-0.8 * r),
      wheel(0.8 * r),
      ...treads,
      shape("path", { class: "nose", d: `M${0.6 * r} ${-0.3 * r}L${0.88 * r} 0L${0.6 * r} ${0.3 * r}` }),
    ];
    // The brick, with its display and its orange button.
    const brick = [
      shape("rect", { class: "brick", x: -0.5 * r, y: -0.42 * r, width: r, height: 0.84 * r, rx: 0.08 * r }),
      shape("rect", { class: "screen", x: -0.02 * r, y: -0.28 * r, width: 0.38 * r, height: 0.56 * r, rx: 3 }),
      shape("circle", { class: "key", cx: -0.26 * r, cy: 0, r: 0.1 * r }),
    ];
    const group = shape(
      "g",
      { class: robot.moves ? "robot" : "robot station" },
      ...parts.rays.map((ray) => ray.shape),
      ...parts.mouths,
      shape("circle", { class: "body", r }),
      ...driven,
      ...brick,
      ...parts.ears,
      ...parts.eyes.map((eye) => eye.shape),
      cup,
      crash,
    );
    const doing = shape("tspan", { class: "doing" });
    const label = shape("text", {}, robot.name + " ", doing);
    return { ...parts, group, cup, crash, label, doing, treads: robot.moves ? treads : [], name: robot.name, radius: r };
  }

  /** The two round fronts of an ultrasonic sensor. */
  ears(sensor) {
    const front = (y) => shape("circle", { cx: 4, cy: y, r: 9 });
    const box = shape("rect", { x: -10, y: -24, width: 16, height: 48, rx: 4 });
    return shape("g", { class: "ears", transform: `translate(${sensor.x} ${-sensor.y}) rotate(${-sensor.facing})` }, box, front(-12), front(12));
  }

  drinker(drinker) {
    const body = shape("circle", { class: "drinker", cx: drinker.x, cy: this.y(drinker.y), r: DRINKER_RADIUS });
    const text = shape("text", { x: drinker.x, y: this.y(drinker.y) + 20 });
    return { name: drinker.name, body, text, group: shape("g", {}, body, text) };
  }

  /** Round, so that it matters to nobody how it lies; its weight stands below its name. */
  thing({ name, radius, mass }) {
    const body = shape("circle", { class: "thing", r: radius });
    const group = shape("g", {}, shape("title", {}, `${name}, ${weight(mass)}`), body);
    const doing = shape("tspan", { class: "doing" }, weight(mass));
    return { name, radius, group, doing, label: shape("text", {}, name + " ", doing) };
  }

  follow(number) {
    this.followed = number;
    this.robots.forEach((robot, index) => robot.group.classList.toggle("followed", index === number));
  }

  /** All of the floor, or what is around the robot that is followed. */
  look() {
    const { width, depth } = this.world;
    let box = [-SVG_MARGIN, -SVG_MARGIN, width + 2 * SVG_MARGIN, depth + 2 * SVG_MARGIN];
    if (this.followed >= 0 && this.place !== undefined) {
      const span = 1600;
      box = [this.place.x - span / 2, this.y(this.place.y) - span / 4, span, span / 2];
    }
    this.svg.setAttribute("viewBox", box.map(Math.round).join(" "));
    // Where a floor is small on the screen, its letters are larger, so that they can be read.
    this.letters = this.width === 0 ? 1 : Math.max(1, (SMALLEST_LETTERS * box[2]) / this.width / LETTERS);
    this.svg.style.setProperty("--letters", this.letters.toFixed(2));
  }

  show(time) {
    this.robots.forEach((shapes, number) => this.showRobot(shapes, number, time));
    const places = this.things.map((shapes, number) => this.showThing(shapes, number, time));
    const labels = this.robots.map((shapes, number) => this.labelled(shapes, this.recording.robot(number, time)));
    this.labels.place([...labels, ...this.things.map((shapes, number) => this.labelled(shapes, places[number]))], this.letters);
    if (this.ghost !== null) {
      this.ghost.show(time);
    }
    this.drinkers.forEach((shapes, number) => {
      const drinker = this.recording.drinker(number, time);
      shapes.body.classList.toggle("away", !drinker.isPresent);
      shapes.text.textContent = shapes.name + " " + drinker.cups;
    });
    this.look();
  }

  showRobot(shapes, number, time) {
    const robot = this.recording.robot(number, time);
    if (number === this.followed) {
      this.place = robot;
    }
    const y = this.y(robot.y);
    shapes.group.setAttribute("transform", `translate(${robot.x} ${y}) rotate(${-robot.heading})`);
    shapes.doing.textContent = robot.display;
    const rolled = shapes.treads.length === 0 ? [] : this.recording.rolled(number, time);
    shapes.treads.forEach((tread, side) => tread.setAttribute("stroke-dashoffset", rolled[side].toFixed(1)));
    for (const ray of shapes.rays) {
      ray.shape.setAttribute("d", cone(ray.sensor, robot.readings[ray.index]));
    }
    for (const eye of shapes.eyes) {
      const isDark = robot.readings[eye.index] < BRIGHT;
      eye.shape.classList.toggle("dark", isDark);
      eye.shape.classList.toggle("bright", !isDark);
    }
    shapes.cup.setAttribute("class", "cup " + robot.cup);
    shapes.cup.toggleAttribute("hidden", robot.cup === "none");
    shapes.crash.toggleAttribute("hidden", !this.collidesAt(number, time));
    this.showTrail(this.trails[number], "robots", number, time);
  }

  /** Its place, too. */
  showThing(shapes, number, time) {
    const place = this.recording.thing(number, time);
    shapes.group.setAttribute("transform", `translate(${place.x} ${this.y(place.y)})`);
    this.showTrail(this.trails[this.robots.length + number], "things", number, time);
    return place;
  }

  showTrail(trail, kind, number, time) {
    const places = this.recording.trail(kind, number, time, TRAIL_SECONDS);
    trail.setAttribute("points", places.map(([x, up]) => x + "," + this.y(up)).join(" "));
  }

  labelled({ label, name, doing, radius }, { x, y }) {
    return { text: label, name, doing: doing.textContent, x, y: this.y(y), radius };
  }

  collidesAt(number, time) {
    const name = this.world.robots[number].name;
    return this.recording.events.some(
      (event) => event.what === "COLLISION" && event.who === name && event.t <= time && time < event.t + 1000,
    );
  }
}

function weight(grams) {
  return grams < 1000 ? grams + " g" : grams / 1000 + " kg";
}

/** What an ultrasonic sensor sees, as far as its echo says. */
function cone(sensor, reading) {
  if (reading >= NO_ECHO) {
    return "";
  }
  const length = 10 * reading;
  const edge = (side) => {
    const angle = ((sensor.facing + side * CONE) * Math.PI) / 180;
    return `${(sensor.x + length * Math.cos(angle)).toFixed(1)} ${(-sensor.y - length * Math.sin(angle)).toFixed(1)}`;
  };
  return `M${sensor.x} ${-sensor.y}L${edge(1)}A${length} ${length} 0 0 1 ${edge(-1)}Z`;
}
