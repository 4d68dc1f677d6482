// Parts that show what is inside can be closed: then that is out of the way, and the wires end at the border.

class Folds {
  static SIZE = 14;

  /**
   * @param changed told the names of closed parts; who can draw the picture anew, with less space for them, does so
   */
  constructor(svg, changed) {
    this.svg = svg;
    this.changed = changed;
    this.closed = new Set();
    this.parts = [...svg.querySelectorAll("[data-part]")].filter((part) => part.classList.contains("folded") || this.inside(part.dataset.part).length > 0);
    this.parts.forEach((part) => this.addHandle(part));
  }

  get any() {
    return this.parts.length > 0;
  }

  get allClosed() {
    return this.parts.every((part) => this.isClosed(part));
  }

  isClosed(part) {
    return part.classList.contains("folded");
  }

  /** Those that are to be seen. */
  closedParts() {
    return this.parts.filter((part) => this.isClosed(part) && !part.classList.contains("hidden-inside"));
  }

  /** What is to be seen and shows what is inside: parts, and the whole. */
  openBoxes() {
    const parts = this.parts.filter((part) => !this.isClosed(part) && !part.classList.contains("hidden-inside"));
    return [...this.svg.querySelectorAll(":scope > .frame"), ...parts];
  }

  /** Elements that lie in a part, at any depth; its own ports are on its border. */
  inside(name) {
    return [...this.svg.children].filter((each) => {
      const place = Folds.placeOf(each.dataset);
      return place === name || place.startsWith(name + ".");
    });
  }

  /** The innermost part that something lies in; empty for the whole. */
  static placeOf({ part, port, in: holder }) {
    if (part !== undefined) {
      return Wires.owner(part);
    }
    return port !== undefined ? Wires.owner(Wires.owner(port)) : holder || "";
  }

  /** A button in the corner of a part, for the pointer and for Tab. */
  addHandle(part) {
    const box = part.querySelector("rect");
    const [x, y] = ["x", "y"].map((name) => Number(box.getAttribute(name)) + 5);
    const size = Folds.SIZE;
    const handle = Folds.shape("g", { class: "fold", role: "button", tabindex: 0 });
    handle.append(
      Folds.shape("rect", { x, y, width: size, height: size, rx: 3 }),
      Folds.shape("path", { class: "level", d: `M${x + 3.5},${y + size / 2} h${size - 7}` }),
      Folds.shape("path", { class: "upright", d: `M${x + size / 2},${y + 3.5} v${size - 7}` }),
    );
    handle.addEventListener("click", (event) => {
      event.preventDefault();
      this.fold(part, !this.isClosed(part));
    });
    handle.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        event.stopPropagation();
        this.fold(part, !this.isClosed(part));
      }
    });
    part.append(handle);
    this.describe(part);
  }

  static shape(name, properties) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    Object.entries(properties).forEach(([key, value]) => made.setAttribute(key, value));
    return made;
  }

  describe(part) {
    const handle = part.querySelector(".fold");
    handle.setAttribute("aria-expanded", String(!this.isClosed(part)));
    handle.setAttribute("aria-label", `inside of ${part.dataset.part}`);
  }

  fold(part, closed) {
    part.classList.toggle("folded", closed);
    this.describe(part);
    this.show();
  }

  foldAll(closed) {
    for (const part of this.parts) {
      part.classList.toggle("folded", closed);
      this.describe(part);
    }
    this.show();
  }

  /** What lies in a closed part, however deep, is hidden. */
  show() {
    const hidden = new Set(this.parts.filter((part) => this.isClosed(part)).flatMap((part) => this.inside(part.dataset.part)));
    for (const each of this.svg.children) {
      each.classList.toggle("hidden-inside", hidden.has(each));
    }
    this.changed(this.parts.filter((part) => this.isClosed(part)).map((part) => part.dataset.part));
  }

  /** Opens whatever hides an element. */
  reveal(element) {
    if (element.classList.contains("hidden-inside")) {
      for (const part of this.parts.filter((each) => this.isClosed(each) && this.inside(each.dataset.part).includes(element))) {
        this.fold(part, false);
      }
    }
  }
}
