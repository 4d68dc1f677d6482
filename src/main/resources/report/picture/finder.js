// Finds texts in a picture: names of parts, ports, states, and what stands at transitions.

class Finder {
  /**
   * @param show told the element that is looked at, or null, and what is to be said about it
   */
  constructor(svg, show) {
    this.svg = svg;
    this.show = show;
    this.found = [];
    this.at = -1;
  }

  /** Looks for a text, whatever the case of its letters; nothing is found for an empty one. */
  find(text) {
    const wanted = text.trim().toLowerCase();
    this.found = wanted === "" ? [] : [...this.svg.querySelectorAll(":scope > g")].filter((each) => Finder.textOf(each).toLowerCase().includes(wanted));
    this.svg.querySelectorAll(".found").forEach((each) => each.classList.remove("found"));
    this.found.forEach((each) => each.classList.add("found"));
    this.at = -1;
    this.show(null, wanted === "" ? "" : this.found.length === 0 ? "not found" : `${this.found.length} found`);
  }

  /** To the next, or to the one before. */
  next(by) {
    if (this.found.length > 0) {
      this.at = this.at < 0 && by < 0 ? this.found.length - 1 : (this.at + by + this.found.length) % this.found.length;
      const element = this.found[this.at];
      this.show(element, `${this.at + 1} of ${this.found.length}: ${Finder.saying(element)}`);
    }
  }

  /** What is drawn, and what else is known of it: a label may be cut. */
  static textOf(element) {
    return [...element.querySelectorAll("text, title")].map((each) => each.textContent).join("\n");
  }

  static saying(element) {
    const title = element.querySelector("title");
    return title ? title.textContent.replace(/\n/g, "; ") : [...element.querySelectorAll("text")].map((each) => each.textContent).join(" ");
  }
}
