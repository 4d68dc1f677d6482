// The rows of a timeline, in groups: what goes in and out, then part by part as the architecture is. A group can be
// folded, and rows and groups be put into another order; both hold for all runs of the page.

/** How groups begin that are parts, before their path. */
const PART = "part ";

/** What of a path and a name is to be read below the heading of the path. */
function shortName(track) {
  if (!track.group.startsWith(PART)) {
    return track.name;
  }
  const path = track.group.slice(PART.length);
  return track.name === path ? "state" : track.name.startsWith(path + ".") ? track.name.slice(path.length + 1) : track.name;
}

/** What a person has arranged. */
class Arrangement {
  constructor() {
    this.folded = new Set();
    this.orders = new Map();
    this.changed = () => {};
  }

  /** Arranges anew; false where nothing is said and nothing was. */
  set(folded, orders) {
    const isSaid = folded.length > 0 || orders.length > 0;
    const was = this.folded.size > 0 || this.orders.size > 0;
    this.folded = new Set(folded);
    this.orders = new Map(orders);
    return isSaid || was;
  }

  /** In the order that somebody gave them; what came later stands behind. */
  arranged(place, all, nameOf) {
    const order = this.orders.get(place) || [];
    const rank = (each) => (order.includes(nameOf(each)) ? order.indexOf(nameOf(each)) : order.length);
    return [...all].sort((one, other) => rank(one) - rank(other));
  }
}

/** Tracks under their headings, and parts inside of the parts that they belong to. */
function groupsOf(tracks) {
  const roots = [];
  const byPath = new Map();
  let last = null;
  for (const track of tracks) {
    if (last === null || last.name !== track.group) {
      last = { name: track.group, tracks: [], inside: [], level: 0 };
      const isPart = track.group.startsWith(PART);
      const path = track.group.slice(PART.length);
      const outer = isPart ? byPath.get(path.slice(0, Math.max(0, path.lastIndexOf(".")))) : undefined;
      last.level = outer === undefined ? 0 : outer.level + 1;
      (outer === undefined ? roots : outer.inside).push(last);
      if (isPart) {
        byPath.set(path, last);
      }
    }
    last.tracks.push(track);
  }
  return roots;
}

class Rows {
  /** @param flaws of the run, @param redraw is asked for when rows come or go */
  constructor(tracks, flaws, arrangement, redraw) {
    this.flaws = flaws;
    this.arrangement = arrangement;
    this.redraw = redraw;
    this.all = new Map();
    this.element = element("div", { class: "rows", onscroll: redraw });
    this.element.append(...this.groups("", groupsOf(tracks)));
    this.element.addEventListener("pointerdown", (event) => this.grip(event));
  }

  /** Those that are to be seen, from above to below. */
  get seen() {
    return [...this.element.querySelectorAll(".track")].map((row) => this.all.get(row)).filter((row) => !isFolded(row.row));
  }

  of(track) {
    return [...this.all.values()].find((row) => row.track === track);
  }

  groups(place, groups) {
    return this.arrangement.arranged(place, groups, (group) => group.name).map((group) => this.group(group));
  }

  group(group) {
    const isPart = group.name.startsWith(PART);
    const rows = this.arrangement.arranged(group.name, group.tracks, (track) => track.name).map((track) => this.row(track));
    const box = element("div", { class: isPart ? "group-box part" : "group-box" });
    box.dataset.name = group.name;
    box.style.setProperty("--level", group.level);
    const heading = element("button", { type: "button", class: "group", onclick: () => this.fold(box) }, group.name);
    box.append(...(group.name === "" ? [] : [heading]), ...rows, ...this.groups(group.name + "/", group.inside));
    this.mark(box, this.arrangement.folded.has(group.name));
    return box;
  }

  row(track) {
    const lane = shape("svg", { class: "lane", height: LANE.height, "aria-hidden": "true" });
    const grip = element("span", { class: "grip", title: "Drag to another place (Alt \u2191 \u2193)", "aria-hidden": "true" });
    const name = element("span", { class: "name", title: track.name }, grip, element("span", {}, shortName(track)));
    const row = element("div", { class: `row track of-${track.kind}` }, name, lane);
    this.all.set(row, { track, row, lane, flaws: this.flaws.filter((flaw) => flaw.track === track.name) });
    return row;
  }

  fold(box, isFolded = !box.classList.contains("folded")) {
    const { folded } = this.arrangement;
    if (isFolded) {
      folded.add(box.dataset.name);
    } else {
      folded.delete(box.dataset.name);
    }
    this.mark(box, isFolded);
    this.arrangement.changed();
    this.redraw();
  }

  mark(box, isFolded) {
    box.classList.toggle("folded", isFolded);
    const heading = box.querySelector(":scope > .group");
    if (heading !== null) {
      heading.setAttribute("aria-expanded", String(!isFolded));
    }
  }

  /** All groups, or if all are folded, none. */
  foldAll() {
    const boxes = [...this.element.querySelectorAll(".group-box")];
    const wanted = !boxes.every((box) => box.classList.contains("folded"));
    boxes.forEach((box) => this.fold(box, wanted));
  }

  /** The group of a row. */
  foldAround(track) {
    this.fold(this.of(track).row.parentElement);
  }

  /** Makes a row be seen, whatever it is folded in. */
  unfold(track) {
    for (let box = this.of(track).row.parentElement; box !== this.element; box = box.parentElement) {
      this.fold(box, false);
    }
  }

  /** Puts a row, or a group by its heading, one place up or down among its like. */
  move(element, direction) {
    const isLike = (other) => other.matches(element.matches(".track") ? ".track" : ".group-box");
    const next = direction < 0 ? element.previousElementSibling : element.nextElementSibling;
    if (next !== null && isLike(next)) {
      place(element, next, direction > 0);
      this.remember(element.parentElement);
      this.redraw();
    }
  }

  remember(parent) {
    const name = parent === this.element ? "" : parent.dataset.name;
    const children = [...parent.children];
    const rows = children.filter((each) => each.matches(".track")).map((row) => this.all.get(row).track.name);
    this.arrangement.orders.set(name, rows);
    const groups = children.filter((each) => each.matches(".group-box")).map((box) => box.dataset.name);
    this.arrangement.orders.set(name === "" ? "" : name + "/", groups);
    this.arrangement.changed();
  }

  /** A row is dragged: it goes where the pointer is, among the rows of its group. */
  grip(event) {
    const row = event.target.closest(".grip") === null ? null : event.target.closest(".track");
    if (row === null) {
      return;
    }
    event.preventDefault();
    const over = (moved) => {
      const other = [...row.parentElement.children].find((each) => each.matches(".track") && each !== row && isOver(each, moved.clientY));
      if (other !== undefined) {
        place(row, other, (row.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING) !== 0);
      }
    };
    const end = () => {
      row.classList.remove("dragged");
      removeEventListener("pointermove", over);
      this.remember(row.parentElement);
      this.redraw();
    };
    row.classList.add("dragged");
    addEventListener("pointermove", over);
    addEventListener("pointerup", end, { once: true });
  }
}

function isOver(row, y) {
  const { top, bottom } = row.getBoundingClientRect();
  return y >= top && y < bottom;
}

function place(one, other, isBehind) {
  if (isBehind) {
    other.after(one);
  } else {
    other.before(one);
  }
}

/** Of a folded part, what it sends is still to be seen; of another group nothing. */
function isFolded(row) {
  const own = row.parentElement;
  const folded = row.closest(".folded");
  return folded !== null && !(folded === own && own.matches(".part") && row.matches(".of-port") && own.parentElement.closest(".folded") === null);
}
