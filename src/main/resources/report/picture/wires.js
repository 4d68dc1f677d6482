// What belongs together in a picture: a wire with all that it forks to, a part or a state with all that leads to it and away.

class Wires {
  constructor(svg) {
    this.svg = svg;
    this.lines = [...svg.querySelectorAll("[data-from]")];
    this.ofPort = new Map();
    for (const line of this.lines.filter(Wires.isConnector)) {
      for (const port of [line.dataset.from, line.dataset.to]) {
        this.ofPort.set(port, [...(this.ofPort.get(port) || []), line]);
      }
    }
  }

  static isConnector(line) {
    return line.dataset.connector !== undefined;
  }

  /** The element that a shape is a part of, or null. */
  static elementOf(shape) {
    return shape.closest("svg.arcomat > g");
  }

  static kind(element) {
    return element.classList[0];
  }

  static name(element) {
    return element.dataset[Wires.kind(element)] || "";
  }

  /** All elements that an element is to be seen with; itself alone where nothing leads there. */
  with(element) {
    const lit = new Set([element]);
    const name = Wires.name(element);
    switch (Wires.kind(element)) {
      case "connector":
        this.addWire(element, lit);
        break;
      case "port":
        (this.ofPort.get(name) || []).forEach((line) => this.addWire(line, lit));
        break;
      case "part":
        this.lines
          .filter((line) => Wires.isConnector(line) && Wires.leadsTo(line, name))
          .forEach((line) => this.addWire(line, lit));
        break;
      case "arrow":
      case "transition":
      case "initial":
        this.addWays(Wires.numbers(element), lit);
        break;
      case "frame":
      case "group":
        break;
      default:
        this.addAround(name, lit);
    }
    return lit;
  }

  /** Whether an end of a line is a port of the part, seen from outside. */
  static leadsTo(line, part) {
    return line.dataset.in !== part && [line.dataset.from, line.dataset.to].some((end) => Wires.owner(end) === part);
  }

  static owner(port) {
    return port.slice(0, Math.max(0, port.lastIndexOf(".")));
  }

  /** From port to port, through the borders of parts that show what is inside. */
  addWire(line, lit) {
    const open = [line];
    while (open.length > 0) {
      const next = open.pop();
      lit.add(next);
      for (const port of [next.dataset.from, next.dataset.to]) {
        this.add(`[data-port="${CSS.escape(port)}"]`, lit);
        open.push(...this.ofPort.get(port).filter((other) => !lit.has(other)));
      }
    }
  }

  /** An arrow stands for several transitions, and so does a label: "2 5"; the arrow of a beginning is "initial 0". */
  static numbers(element) {
    const name = Wires.name(element);
    if (Wires.kind(element) === "initial") {
      return [`initial ${name}`];
    }
    return name.startsWith("initial") ? [name] : name.split(" ");
  }

  /** Transitions from end to end, with their labels: some share the last piece of their way. */
  addWays(numbers, lit) {
    for (const element of this.svg.querySelectorAll("[data-arrow], [data-transition], [data-initial]")) {
      if (Wires.numbers(element).some((each) => numbers.includes(each))) {
        lit.add(element);
        for (const end of [element.dataset.from, element.dataset.to].filter((each) => each !== undefined)) {
          const name = CSS.escape(end);
          this.add(`[data-state="${name}"], [data-junction="${name}"], [data-start="${name}"]`, lit);
        }
      }
    }
  }

  /** A state, or a class in a diagram: all lines that begin or end there. */
  addAround(name, lit) {
    for (const line of this.lines.filter((each) => each.dataset.from === name || each.dataset.to === name)) {
      if (Wires.kind(line) === "arrow") {
        this.addWays(Wires.numbers(line), lit);
      } else {
        lit.add(line);
      }
    }
  }

  add(selector, lit) {
    this.svg.querySelectorAll(selector).forEach((each) => lit.add(each));
  }

  /** Lights an element with what belongs to it; nothing for null. */
  light(element) {
    const lit = element === null ? new Set() : this.with(element);
    this.svg.classList.toggle("lighting", lit.size > 1);
    this.svg.querySelectorAll(".lit").forEach((each) => each.classList.toggle("lit", lit.has(each)));
    lit.forEach((each) => each.classList.add("lit"));
  }
}
