// What is closed becomes as small as a part without an inside, and what is around it closes up. Nothing is laid out anew: columns
// and rows in which nothing stands any more are taken out of the picture. So no wire gets another bend, and nothing meets that did not.

class Shrinking {
  /** What is left of a column or a row in which nothing stands. */
  static GAP = 10;

  /** Inside of a box: beside its ports, and above them for each line of its title. */
  static BESIDE = 13;
  static ABOVE = 20;
  static LINE = 15;
  static BELOW = 20;

  /** A corner of a wire is not longer. */
  static CORNER = 5.1;

  static SHAPES = "rect, circle, text, path, polygon";

  constructor(svg) {
    this.svg = svg;
    const { width, height } = svg.viewBox.baseVal;
    this.size = { width, height };
    this.written = new Map();
  }

  /**
   * @param closed parts that are closed, and not hidden in others
   * @param open boxes that show what is inside
   */
  show(closed, open) {
    this.restore();
    this.remember();
    const spans = closed.map((part) => Shrinking.box(part));
    closed.forEach((part) => this.makeLeaf(part));
    const right = this.squeeze("x", spans, closed, open);
    const down = this.squeeze("y", spans, closed, open);
    for (const shape of this.written.keys()) {
      Shrinking.move(shape, right, down);
    }
    open.forEach((each) => Shrinking.centre(each));
    this.resize(right(this.size.width), down(this.size.height));
  }

  resize(width, height) {
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.setAttribute("width", width);
    this.svg.setAttribute("height", height);
  }

  /** As it was drawn. */
  restore() {
    for (const [shape, attributes] of this.written) {
      attributes.forEach(([name, value]) => shape.setAttribute(name, value));
    }
  }

  /** Shapes may have come since: texts on wires. */
  remember() {
    for (const shape of this.svg.querySelectorAll(Shrinking.SHAPES)) {
      if (!this.written.has(shape)) {
        const names = ["x", "y", "width", "height", "cx", "cy", "d", "points"].filter((name) => shape.hasAttribute(name));
        this.written.set(shape, names.map((name) => [name, shape.getAttribute(name)]));
      }
    }
  }

  static number(shape, name) {
    return Number(shape.getAttribute(name));
  }

  static box(element) {
    const rect = element.querySelector("rect");
    const [x, y, width, height] = ["x", "y", "width", "height"].map((name) => Shrinking.number(rect, name));
    return { x: [x, x + width], y: [y, y + height] };
  }

  static texts(element) {
    return [...element.querySelectorAll("text")];
  }

  static length(text) {
    return Shrinking.number(text, "textLength");
  }

  static longest(texts) {
    return texts.reduce((longest, text) => Math.max(longest, Shrinking.length(text)), 0);
  }

  /** Points of a path or a polygon. */
  static points(shape) {
    const text = shape.getAttribute(shape.tagName === "path" ? "d" : "points");
    return [...text.matchAll(/(-?[\d.]+),(-?[\d.]+)/g)].map((pair) => ({ x: Number(pair[1]), y: Number(pair[2]) }));
  }

  // A box that becomes a leaf

  /** Its ports stay in their rows; those on the right come nearer, and their wires begin there. */
  makeLeaf(part) {
    const box = Shrinking.box(part);
    const ports = this.portsOf(part);
    const [left, right] = [0, 1].map((side) => ports.filter((port) => Math.abs(Shrinking.middle(port) - box.x[side]) < 1));
    const wires = new Map(right.map((port) => [port, this.wiresFrom(port)]));
    if (left.length + right.length < ports.length || [...wires.values()].includes(null)) {
      return; // not as the tool draws it: then it stays as large as it is
    }
    const titles = Shrinking.texts(part);
    const labels = [left, right].map((side) => Shrinking.longest(side.flatMap(Shrinking.texts)));
    const handle = 2 * (Folds.SIZE + 8);
    const width = Math.min(box.x[1] - box.x[0], Math.max(Shrinking.longest(titles) + handle, labels[0] + labels[1] + 3 * Shrinking.BESIDE));
    const rows = ports.map((port) => Shrinking.number(port.querySelector("rect"), "y"));
    const head = Shrinking.ABOVE + Shrinking.LINE * titles.length;
    const top = Math.max(box.y[0], rows.length === 0 ? box.y[0] : Math.min(...rows) - head);
    const bottom = rows.length === 0 ? top + head : Math.max(...rows) + Shrinking.BELOW;
    const nearer = width - (box.x[1] - box.x[0]);
    for (const port of ports) {
      const row = Shrinking.number(port.querySelector("rect"), "y");
      Shrinking.texts(port).forEach((text) => text.setAttribute("y", row + 7.5));
    }
    for (const [port, lines] of wires) {
      Shrinking.shift([port, ...this.signsBeside(port)], nearer, 0);
      lines.forEach((line) => Shrinking.beginFurtherLeft(line, nearer));
    }
    titles.forEach((text) => text.setAttribute("x", box.x[0] + (width - Shrinking.length(text)) / 2));
    Shrinking.shift([part], 0, top - box.y[0]);
    const rect = part.querySelector("rect");
    rect.setAttribute("width", width);
    rect.setAttribute("height", bottom - top);
  }

  portsOf(part) {
    return [...this.svg.querySelectorAll("g[data-port]")].filter((port) => Wires.owner(port.dataset.port) === part.dataset.part);
  }

  static middle(port) {
    const { x } = Shrinking.box(port);
    return (x[0] + x[1]) / 2;
  }

  /** The paths of wires that lead away, all to the right; null where one does something else. */
  wiresFrom(port) {
    const name = port.dataset.port;
    const outside = [...this.svg.querySelectorAll("[data-connector]")].filter((wire) => wire.dataset.in !== Wires.owner(name));
    const from = outside.filter((wire) => wire.dataset.from === name).map((wire) => wire.querySelector("path"));
    const isPlain = (path) => {
      const [first, second] = Shrinking.points(path);
      return Math.abs(first.y - second.y) < 0.1 && second.x >= first.x;
    };
    return outside.some((wire) => wire.dataset.to === name) || !from.every(isPlain) ? null : from;
  }

  /** What pages write beside ports. */
  signsBeside(port) {
    return [...this.svg.querySelectorAll(`[data-beside="${CSS.escape(port.dataset.port)}"]`)];
  }

  static beginFurtherLeft(path, by) {
    const [first] = Shrinking.points(path);
    path.setAttribute("d", path.getAttribute("d").replace(/^M[^ ]+/, `M${first.x + by},${first.y}`));
  }

  static shift(elements, right, down) {
    for (const shape of elements.flatMap((each) => (each.matches(Shrinking.SHAPES) ? [each] : [...each.querySelectorAll(Shrinking.SHAPES)]))) {
      Shrinking.move(shape, (x) => x + right, (y) => y + down);
    }
  }

  /** Moves a shape by where its points go. */
  static move(shape, right, down) {
    const moved = (name, to) => shape.setAttribute(name, to(Shrinking.number(shape, name)));
    switch (shape.tagName) {
      case "rect": {
        const { x, y } = Shrinking.box({ querySelector: () => shape });
        shape.setAttribute("width", right(x[1]) - right(x[0]));
        shape.setAttribute("height", down(y[1]) - down(y[0]));
        moved("x", right);
        moved("y", down);
        break;
      }
      case "circle":
        moved("cx", right);
        moved("cy", down);
        break;
      case "text":
        moved("x", right);
        moved("y", down);
        break;
      default: {
        const name = shape.tagName === "path" ? "d" : "points";
        const pairs = (all, x, y) => `${right(Number(x))},${down(Number(y))}`;
        shape.setAttribute(name, shape.getAttribute(name).replace(/(-?[\d.]+),(-?[\d.]+)/g, pairs));
      }
    }
  }

  /** The title of a box that shows what is inside. */
  static centre(element) {
    const { x } = Shrinking.box(element);
    Shrinking.texts(element).forEach((text) => text.setAttribute("x", (x[0] + x[1] - Shrinking.length(text)) / 2));
  }

  // Columns and rows

  /** Where each place goes, when what is empty between the ends of closed boxes is taken out. */
  squeeze(axis, spans, closed, open) {
    const stiff = new Set();
    for (;;) {
      const cuts = this.cuts(axis, spans, this.taken(axis, closed, open, stiff));
      const to = (place) => cuts.reduce((sum, [from, until]) => sum - Shrinking.cutOff(place, from, until), place);
      const narrow = axis === "x" ? open.find((each) => !stiff.has(each) && Shrinking.isTooNarrow(each, to)) : undefined;
      if (narrow === undefined) {
        return to;
      }
      stiff.add(narrow);
    }
  }

  static cutOff(place, from, until) {
    const share = Math.max(0, Math.min(1, (place - from) / (until - from)));
    return share * (until - from - Shrinking.GAP);
  }

  static isTooNarrow(element, to) {
    const { x } = Shrinking.box(element);
    return to(x[1]) - to(x[0]) < Shrinking.longest(Shrinking.texts(element)) + 2 * (Folds.SIZE + 8);
  }

  /** Long enough stretches of a closed box that nothing takes. */
  cuts(axis, spans, taken) {
    const cuts = [];
    for (const [from, until] of Shrinking.merged(spans.map((span) => span[axis]))) {
      let free = from;
      for (const [begin, end] of taken.filter(([begin, end]) => end >= from && begin <= until)) {
        cuts.push([free, begin]);
        free = Math.max(free, end);
      }
      cuts.push([free, until]);
    }
    return cuts.filter(([from, until]) => until - from > Shrinking.GAP);
  }

  static merged(intervals) {
    const all = [];
    for (const [from, until] of [...intervals].sort((one, other) => one[0] - other[0])) {
      const last = all[all.length - 1];
      if (last !== undefined && from <= last[1]) {
        last[1] = Math.max(last[1], until);
      } else {
        all.push([from, until]);
      }
    }
    return all;
  }

  /** @param stiff boxes whose title takes its place */
  taken(axis, closed, open, stiff) {
    const intervals = [];
    for (const element of this.svg.children) {
      if (element.classList.contains("hidden-inside")) {
        continue;
      }
      const border = closed.includes(element) || open.includes(element) ? element.querySelector("rect") : null;
      for (const shape of element.matches(Shrinking.SHAPES) ? [element] : element.querySelectorAll(Shrinking.SHAPES)) {
        if (shape === border) {
          const [from, until] = Shrinking.box(element)[axis];
          intervals.push(...(axis === "x" && closed.includes(element) ? [[from, until]] : [[from, from], [until, until]]));
        } else if (axis === "y" || shape.tagName !== "text" || !open.includes(element) || stiff.has(element)) {
          intervals.push(...Shrinking.takenBy(shape, axis));
        }
      }
    }
    return Shrinking.merged(intervals);
  }

  static takenBy(shape, axis) {
    const at = (name) => Shrinking.number(shape, name);
    switch (shape.tagName) {
      case "rect":
        return [Shrinking.box({ querySelector: () => shape })[axis]];
      case "circle":
        return [[at("c" + axis) - at("r"), at("c" + axis) + at("r")]];
      case "text":
        return [axis === "x" ? [at("x"), at("x") + Shrinking.length(shape)] : [at("y") - 11, at("y") + 3]];
      default:
        return Shrinking.takenByLine(Shrinking.points(shape), axis);
    }
  }

  /** Along a straight piece there may be more or less of it; its ends and corners keep their forms. */
  static takenByLine(points, axis) {
    const across = axis === "x" ? "y" : "x";
    const taken = [[points[0][axis], points[0][axis]]];
    for (let i = 1; i < points.length; i++) {
      const [from, until] = [points[i - 1][axis], points[i][axis]].sort((one, other) => one - other);
      const isStraight = Math.abs(points[i][across] - points[i - 1][across]) < 0.1 && until - from > Shrinking.CORNER;
      taken.push(...(isStraight ? [[from, from], [until, until]] : [[from, until]]));
    }
    return taken;
  }
}
