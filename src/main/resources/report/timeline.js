// The timeline: a ruler, a row per track, an overview of the whole run, and the cursor.

const OVERVIEW = 26;

class Timeline {
  /** @param actions of the story: go(step), select(row) */
  constructor(story, colours, arrangement, actions) {
    this.story = story;
    this.colours = colours;
    this.actions = actions;
    this.view = new View(story.length);
    this.found = [];
    this.redraw = onceAFrame(() => this.draw());
    const shown = story.tracks.filter((track) => track.kind !== "reason" && track.kind !== "path");
    this.groups = new Rows(shown, story.flaws, arrangement, this.redraw);
    this.element = this.build();
    this.isFresh = true;
    new ResizeObserver(() => this.measure()).observe(this.ruler);
  }

  build() {
    this.ruler = shape("svg", { class: "ruler", "aria-hidden": "true" });
    const body = this.groups.element;
    this.body = body;
    this.cursor = element("div", { class: "cursor" });
    this.window = element("div", { class: "lanes-window" }, this.cursor);
    this.overview = shape("svg", { class: "overview", "aria-hidden": "true" });
    const head = element("div", { class: "row head" }, element("span", { class: "name unit" }, this.story.unit), this.ruler);
    const foot = element("div", { class: "row foot" }, element("span", { class: "name unit" }, "whole run"), this.overview);
    const all = element(
      "div",
      { class: "timeline", id: "timeline", tabindex: "0", role: "group", "aria-label": "Timeline; arrow keys step" },
      head,
      body,
      foot,
      this.window,
    );
    all.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    body.addEventListener("click", (event) => this.click(event));
    scrub(this.ruler, (x) => this.actions.go(this.view.step(x)));
    scrub(this.overview, (x) => this.pickFromOverview(x));
    return all;
  }

  /** Those that are to be seen, from above to below. */
  get rows() {
    return this.groups.seen;
  }

  get tracks() {
    return this.rows.map((row) => row.track);
  }

  /** A row by its name, folded or not. */
  find(name) {
    return this.story.tracks.find((track) => track.name === name && this.groups.of(track) !== undefined) || null;
  }

  measure() {
    const width = this.ruler.clientWidth;
    if (width === 0 || (width === this.view.width && !this.isFresh)) {
      return;
    }
    this.view.width = width;
    if (this.isFresh) {
      this.isFresh = false;
      this.view.showWell(this.story.cursor);
    }
    this.redraw();
  }

  draw() {
    this.drawRuler();
    this.drawOverview();
    this.placeCursor();
    const seen = this.body.getBoundingClientRect();
    const top = Math.max(seen.top, 0) - LANE.height;
    const bottom = Math.min(seen.bottom, window.innerHeight) + 20 * LANE.height;
    for (const { track, row, lane, flaws } of this.rows) {
      const place = row.getBoundingClientRect();
      if (place.bottom >= top && place.top <= bottom) {
        drawLane(lane, track, this.view, this.colours, flaws);
      }
    }
  }

  drawRuler() {
    const view = this.view;
    const marks = thinned(this.found, view, view.from, view.from + view.span);
    const path = marks.map((x) => `M${round(x - 3)} 25h6l-3 -5z`).join("");
    this.ruler.replaceChildren(...rulerShapes(view, this.story), shape("path", { class: "found", d: path }));
  }

  drawOverview() {
    const view = this.view;
    const scale = view.width / view.length;
    const all = { width: view.width, from: 0, span: view.length, pixelsPerStep: scale, x: (step) => step * scale };
    const from = view.from * scale;
    const marks = thinned(this.found, all, 0, view.length).map((x) => `M${round(x)} 4v18`);
    const flaws = this.story.flaws.map((flaw) => `M${round((flaw.at + 0.5) * scale)} 4v18`);
    this.overview.replaceChildren(
      shape("rect", { class: "whole", x: 0, y: 7, width: view.width, height: OVERVIEW - 14, rx: 6 }),
      shape("rect", { class: "window", x: round(from), y: 4, width: round(Math.max(6, view.span * scale)), height: OVERVIEW - 8, rx: 5 }),
      shape("path", { class: "found", d: marks.join("") }),
      shape("path", { class: "flaw-line", d: flaws.join("") }),
      shape("path", { class: "here", d: `M${round((this.story.cursor + 0.5) * scale)} 2v${OVERVIEW - 4}` }),
    );
  }

  placeCursor() {
    const view = this.view;
    const width = Math.max(2, view.pixelsPerStep);
    const x = view.x(this.story.cursor + 0.5) - width / 2;
    this.cursor.style.transform = `translateX(${x}px)`;
    this.cursor.style.width = `${width}px`;
  }

  /** Shows where the cursor is now. */
  follow() {
    this.view.reveal(this.story.cursor);
    this.redraw();
  }

  mark(track) {
    if (track !== null && !this.tracks.includes(track)) {
      this.groups.unfold(track);
    }
    for (const row of this.groups.all.values()) {
      row.row.classList.toggle("selected", row.track === track);
      if (row.track === track) {
        row.row.scrollIntoView({ block: "nearest" });
      }
    }
  }

  move(track, direction) {
    this.groups.move(this.groups.of(track).row, direction);
    this.mark(track);
  }

  zoom(factor, step = this.story.cursor) {
    this.view.zoom(factor, step);
    this.redraw();
  }

  showAll() {
    this.view.showAll();
    this.redraw();
  }

  click(event) {
    const row = this.rows.find((each) => each.row.contains(event.target));
    if (row === undefined || String(document.getSelection()) !== "") {
      return;
    }
    this.actions.select(row.track);
    const x = event.clientX - row.lane.getBoundingClientRect().left;
    if (x >= 0) {
      this.actions.go(this.view.step(x));
    }
  }

  wheel(event) {
    const x = event.clientX - this.ruler.getBoundingClientRect().left;
    if (event.ctrlKey || event.altKey) {
      this.zoom(Math.exp(-event.deltaY / 300), this.view.step(clamp(x, 0, this.view.width)));
    } else if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
      this.view.pan((event.deltaX || event.deltaY) / this.view.pixelsPerStep);
      this.redraw();
    } else {
      return;
    }
    event.preventDefault();
  }

  pickFromOverview(x) {
    const step = (x / this.view.width) * this.view.length;
    this.view.show(step - this.view.span / 2, this.view.span);
    this.actions.go(clamp(Math.floor(step), 0, this.view.length - 1));
  }
}

/** The numbers of steps, and where flaws are. */
function rulerShapes(view, story) {
  const shapes = [];
  const end = Math.min(view.from + view.span, view.length);
  const tick = niceDistance(64 / view.pixelsPerStep);
  for (let step = Math.ceil(view.from / tick) * tick; step < end; step += tick) {
    const x = view.x(step + 0.5);
    shapes.push(shape("path", { class: "tick", d: `M${round(x)} 20v5` }));
    const label = story.label(step);
    const half = (label.length * LETTER) / 2;
    shapes.push(shape("text", { x: round(clamp(x, half, view.width - half)), y: 15 }, label));
  }
  for (const flaw of story.flaws) {
    if (flaw.at >= view.from && flaw.at < end) {
      const x = view.x(flaw.at + 0.5);
      shapes.push(shape("path", { class: "flaw-mark", d: `M${round(x - 5)} 17h10l-5 8z` }));
    }
  }
  return shapes;
}

/** Calls back with every place that a pointer that is held down comes over. */
function scrub(place, action) {
  const at = (event) => action(event.clientX - place.getBoundingClientRect().left);
  place.addEventListener("pointerdown", (event) => {
    place.setPointerCapture(event.pointerId);
    at(event);
  });
  place.addEventListener("pointermove", (event) => {
    if (place.hasPointerCapture(event.pointerId)) {
      at(event);
    }
  });
}

/** 1, 2, 5, 10, 20 and so on: the first that is no less. */
function niceDistance(least) {
  const power = 10 ** Math.floor(Math.log10(Math.max(1, least)));
  return [1, 2, 5, 10].map((factor) => factor * power).find((distance) => distance >= least) || 10 * power;
}

/** Where steps of a sorted list are, at most one for two pixels. */
function thinned(steps, view, from, to) {
  const places = [];
  let last = -COLUMN;
  for (let i = firstAtLeast(steps, from); i < steps.length && steps[i] < to; i++) {
    const x = view.x(steps[i] + 0.5);
    if (x >= last + COLUMN) {
      places.push(x);
      last = x;
    }
  }
  return places;
}

/** The position of the first that is no less, in a sorted list. */
function firstAtLeast(sorted, wanted) {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < wanted) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}
