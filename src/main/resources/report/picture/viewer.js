// A picture in a window of its own: nearer and farther, moved about, lit up, folded and searched. It needs nothing of the page
// around it but its style sheet; the picture is an SVG that the tool wrote.

class PictureViewer {
  /** Smaller than that, letters cannot be read: then a picture is moved about, and not shrunk any more. */
  static SMALLEST = 0.65;

  static LARGEST = 4;

  /** By a key, a button, or a notch of the wheel. */
  static NEARER = 1.25;

  /** A pointer that moves less is a click. */
  static CLICK = 4;

  static TOOLS = `
    <div class="viewer-tools">
      <span class="viewer-buttons">
        <button type="button" data-do="farther" aria-label="Smaller" title="Smaller (-)">&minus;</button>
        <button type="button" data-do="actual" aria-label="As large as drawn" title="As large as drawn (1)">100 %</button>
        <button type="button" data-do="nearer" aria-label="Larger" title="Larger (+)">+</button>
        <button type="button" data-do="fit" aria-label="Fit into the window" title="Fit into the window (0)">Fit</button>
        <button type="button" data-do="whole" aria-label="On the whole screen" title="On the whole screen (w)">Whole screen</button>
      </span>
      <button type="button" data-do="fold" title="Close all parts, or open them (c)">Close parts</button>
      <input type="search" placeholder="Find" aria-label="Find in the picture" title="Find (/), Enter for the next" spellcheck="false" autocomplete="off">
      <details class="viewer-legend"><summary>Legend</summary><ul></ul></details>
      <output aria-live="polite"></output>
    </div>
    <div class="viewer-window drawing" tabindex="0" role="region"></div>`;

  /**
   * @param svg a picture of the tool, which the viewer takes
   * @param name of what is drawn, for those who cannot see it
   * @param folded told the names of parts that were closed, where somebody draws the picture anew then; else it is closed up
   */
  constructor(svg, name, folded = null) {
    this.name = name;
    this.folded = folded;
    this.scale = 1;
    this.fitted = true;
    this.element = document.createElement("div");
    this.element.className = "viewer";
    this.element.innerHTML = PictureViewer.TOOLS;
    this.window = this.element.querySelector(".viewer-window");
    this.window.setAttribute("aria-label", `Picture of ${name}; arrows move it, + and - change its size, / finds`);
    this.search = this.element.querySelector("input");
    this.renew(svg);
    this.listen();
    new ResizeObserver(() => this.fitted && this.fit()).observe(this.window);
  }

  /** Another picture of the same thing: it is seen as the one before was. */
  renew(svg) {
    const { scrollLeft, scrollTop } = this.window;
    const focused = this.window.contains(document.activeElement) && document.activeElement.closest("[data-part]");
    this.svg = svg;
    this.pinned = null;
    this.wires = new Wires(svg);
    this.folds = new Folds(svg, (closed) => this.foldedTo(closed));
    this.finder = new Finder(svg, (element, said) => this.showFound(element, said));
    this.shrinking = null;
    this.measure();
    svg.setAttribute("role", "group"); // what is in it can be reached
    svg.setAttribute("aria-label", this.name);
    this.window.replaceChildren(svg);
    this.element.querySelector("details > ul").replaceWith(Legend.of(svg));
    this.tool("fold").hidden = !this.folds.any;
    this.nameFold();
    if (this.fitted) {
      this.fit();
    } else {
      this.setScale(this.scale);
      this.window.scrollTo(scrollLeft, scrollTop);
    }
    this.finder.find(this.search.value);
    if (focused) {
      (svg.querySelector(`[data-part="${CSS.escape(focused.dataset.part)}"] > .fold`) || this.window).focus();
    }
  }

  measure() {
    const { width, height } = this.svg.viewBox.baseVal;
    this.size = { width, height };
  }

  tool(name) {
    return this.element.querySelector(`[data-do="${name}"]`);
  }

  listen() {
    this.element.addEventListener("click", (event) => {
      const asked = event.target.closest("[data-do]");
      if (asked) {
        this.act(asked.dataset.do);
      }
    });
    this.element.addEventListener("keydown", (event) => this.key(event));
    this.search.addEventListener("input", () => this.finder.find(this.search.value));
    this.window.addEventListener("mouseover", (event) => this.wires.light(this.isDragged ? this.pinned : Wires.elementOf(event.target) || this.pinned));
    this.window.addEventListener("mouseleave", () => this.wires.light(this.pinned));
    this.window.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.window.addEventListener("pointerdown", (event) => this.grasp(event));
    this.window.addEventListener("pointermove", (event) => this.drag(event));
    this.window.addEventListener("pointerup", () => this.release());
    this.window.addEventListener("pointercancel", () => this.release());
    // After a click, keys go on to be the page's; who wants those of the picture gets there by Tab.
    this.window.addEventListener("mousedown", (event) => event.target.closest("text") || event.preventDefault());
    this.window.addEventListener("mouseup", () => this.window.blur());
    this.window.addEventListener("focusin", (event) => this.wires.light(Wires.elementOf(event.target) || this.pinned));
  }

  act(what) {
    const actions = {
      nearer: () => this.zoom(PictureViewer.NEARER),
      farther: () => this.zoom(1 / PictureViewer.NEARER),
      actual: () => this.show(1),
      fit: () => this.fit(),
      whole: () => (document.fullscreenElement ? document.exitFullscreen() : this.element.requestFullscreen()).catch(() => {}),
      fold: () => this.folds.foldAll(!this.folds.allClosed),
    };
    actions[what]();
  }

  // Size

  /** All of it, or, where letters would become too small, its upper left corner. */
  fit() {
    const { clientWidth } = this.window;
    if (clientWidth === 0) {
      return; // not shown yet
    }
    const height = parseFloat(getComputedStyle(this.window).maxHeight);
    const scale = Math.min(1, clientWidth / this.size.width, height / this.size.height);
    this.setScale(Math.max(PictureViewer.SMALLEST, scale));
    this.fitted = true;
  }

  show(scale) {
    this.zoom(scale / this.scale);
  }

  /** What is at a place of the window, by default its middle, stays there. */
  zoom(factor, x = this.window.clientWidth / 2, y = this.window.clientHeight / 2) {
    const before = this.scale;
    const left = (this.window.scrollLeft + x) / before;
    const top = (this.window.scrollTop + y) / before;
    this.setScale(before * factor);
    this.window.scrollTo(left * this.scale - x, top * this.scale - y);
    this.fitted = false;
  }

  /** As small as all of it in the window, but no smaller than that or readable. */
  setScale(wanted) {
    const whole = Math.min(this.window.clientWidth / this.size.width, PictureViewer.SMALLEST);
    this.scale = Math.max(Math.min(whole, 1), Math.min(PictureViewer.LARGEST, wanted));
    this.svg.style.width = `${Math.floor(this.size.width * this.scale)}px`;
    this.svg.style.height = "auto";
    this.tool("actual").textContent = `${Math.round(this.scale * 100)} %`;
  }

  wheel(event) {
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      const place = this.window.getBoundingClientRect();
      this.zoom(event.deltaY < 0 ? PictureViewer.NEARER : 1 / PictureViewer.NEARER, event.clientX - place.left, event.clientY - place.top);
    }
  }

  // Moving

  grasp(event) {
    const selects = event.target.closest("text, .fold");
    if (event.button === 0 && event.pointerType === "mouse" && !selects) {
      this.grasped = { x: event.clientX, y: event.clientY, left: this.window.scrollLeft, top: this.window.scrollTop };
    }
  }

  drag(event) {
    if (!this.grasped) {
      return;
    }
    const [right, down] = [event.clientX - this.grasped.x, event.clientY - this.grasped.y];
    if (!this.isDragged && Math.hypot(right, down) > PictureViewer.CLICK) {
      this.isDragged = true;
      this.window.setPointerCapture(event.pointerId);
      this.window.classList.add("dragged");
    }
    if (this.isDragged) {
      this.window.scrollTo(this.grasped.left - right, this.grasped.top - down);
    }
  }

  release() {
    this.grasped = null;
    this.isDragged = false;
    this.window.classList.remove("dragged");
  }

  // Keys

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    const used = event.target === this.search ? this.searchKey(event) : this.windowKey(event.key);
    if (used) {
      event.stopPropagation();
    }
    if (used === "done") {
      event.preventDefault();
    }
  }

  /** Letters are written; the page has no keys while they are. */
  searchKey(event) {
    if (event.key === "Enter") {
      this.finder.next(event.shiftKey ? -1 : 1);
      return "done";
    }
    if (event.key === "Escape") {
      this.search.value = "";
      this.finder.find("");
      this.window.focus();
      return "done";
    }
    return "left to the browser";
  }

  windowKey(key) {
    const actions = {
      "+": () => this.act("nearer"),
      "=": () => this.act("nearer"),
      "-": () => this.act("farther"),
      0: () => this.act("fit"),
      1: () => this.act("actual"),
      c: () => this.act("fold"),
      w: () => this.act("whole"),
      n: () => this.finder.next(1),
      N: () => this.finder.next(-1),
      "/": () => this.search.focus(),
    };
    if (Object.hasOwn(actions, key)) {
      actions[key]();
      return "done";
    }
    const { scrollWidth, clientWidth, scrollHeight, clientHeight } = this.window;
    const moves = (key === "ArrowLeft" || key === "ArrowRight") ? scrollWidth > clientWidth : key.startsWith("Arrow") && scrollHeight > clientHeight;
    return moves ? "left to the browser" : "";
  }

  // Finding and folding

  /** The one that is looked at is moved into sight and stays lit. */
  showFound(element, said) {
    this.element.querySelector("output").textContent = said;
    this.pinned = element;
    this.wires.light(element);
    if (element !== null) {
      this.folds.reveal(element);
      element.scrollIntoView({ block: "nearest", inline: "nearest" });
    }
  }

  foldedTo(closed) {
    this.nameFold();
    if (this.folded !== null) {
      this.folded(closed);
      return;
    }
    this.shrinking ??= new Shrinking(this.svg);
    this.shrinking.show(this.folds.closedParts(), this.folds.openBoxes());
    this.measure();
    if (this.fitted) {
      this.fit();
    } else {
      this.setScale(this.scale);
    }
  }

  nameFold() {
    this.tool("fold").textContent = this.folds.allClosed ? "Open parts" : "Close parts";
  }
}
