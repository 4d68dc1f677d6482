// A run with all around it, and the list of runs where there are several.

class Story {
  /** @param moved is told when another step or row is shown */
  constructor(data, colours, arrangement, moved) {
    Object.assign(this, data);
    this.moved = moved;
    this.arrangement = arrangement;
    this.tracks = data.tracks.map((track) => new Track(track));
    this.flaws.sort((one, other) => one.at - other.at);
    this.cursor = this.flaws.length > 0 ? this.flaws[0].at : 0;
    this.selected = null;
    this.colours = colours;
  }

  /** How a step is called: by its time where it has one. */
  label(step) {
    return this.times.length > step ? (this.times[step] / 1000).toFixed(2) + " s" : String(step);
  }

  show(place) {
    const go = (step) => this.go(step);
    const parts = [element("h2", {}, this.title), element("p", { class: "headline " + this.tone, hidden: this.headline === "" }, this.headline)];
    parts.push(facts(this), remarks(this, go));
    this.pictures = new Pictures(this);
    if (this.length > 0) {
      this.timeline = new Timeline(this, this.colours, this.arrangement, { go, select: (track) => this.select(track) });
      this.moment = new Moment(this, this.colours, go);
      this.search = new Search(this, (steps) => this.found(steps), go);
      this.paper = new Paper(this);
      parts.push(this.toolbar(), this.timeline.element, this.paper.element, element("div", { class: "beside" }, this.moment.element, this.pictures.element));
    } else {
      parts.push(this.pictures.element);
    }
    place.replaceChildren(...parts);
    if (this.length > 0) {
      this.go(this.cursor);
    }
  }

  toolbar() {
    const last = this.length - 1;
    this.number = element("input", {
      type: "number",
      id: "step",
      min: 0,
      max: last,
      "aria-label": `Go to ${this.unit}`,
      onchange: () => this.go(Number(this.number.value)),
    });
    this.time = element("span", { class: "time" });
    this.play = new Play(this);
    return element(
      "div",
      { class: "toolbar", role: "toolbar", "aria-label": "Run" },
      ...this.tools(),
    );
  }

  tools() {
    const last = this.length - 1;
    return [
      element("span", { class: "play" }, ...this.play.elements),
      element(
        "span",
        { class: "buttons" },
        button("|\u25c2", "First (Home)", () => this.go(0)),
        button("\u25c2\u25c2", "Change before (Shift Left)", () => this.toChange(-1)),
        button("\u25c2", "Step back (Left)", () => this.go(this.cursor - 1)),
        button("\u25b8", "Step (Right)", () => this.go(this.cursor + 1)),
        button("\u25b8\u25b8", "Next change (Shift Right)", () => this.toChange(1)),
        button("\u25b8|", "Last (End)", () => this.go(last)),
      ),
      element("label", { class: "where" }, this.unit, this.number, ` of 0\u2013${last}`, this.time),
      this.zooms(),
      this.search.element,
      button("?", "Keys (?)", () => showHelp(), { class: "help" }),
    ];
  }

  zooms() {
    return element(
      "span",
      { class: "buttons" },
      button("\u2212", "Show more of the run (-)", () => this.timeline.zoom(1 / 1.6)),
      button("+", "Show less of it, larger (+)", () => this.timeline.zoom(1.6)),
      button("all", "Show the whole run (0)", () => this.timeline.showAll()),
    );
  }

  go(step) {
    this.cursor = clamp(Number.isFinite(step) ? Math.floor(step) : 0, 0, this.length - 1);
    this.number.value = this.cursor;
    this.time.textContent = this.times.length > 0 ? this.label(this.cursor) : "";
    this.moment.show(this.cursor);
    this.pictures.show(this.cursor);
    this.timeline.follow();
    this.search.tell();
    this.moved();
  }

  /** To where the chosen track changes, or any of them if none is chosen. */
  toChange(direction) {
    const tracks = this.selected === null ? this.timeline.tracks : [this.selected];
    const steps = tracks
      .filter((track) => track.count > 0)
      .map((track) => (direction > 0 ? track.nextChange(this.cursor) : track.previousChange(this.cursor)))
      .filter((step) => step >= 0);
    if (steps.length > 0) {
      this.go(direction > 0 ? least(steps) : greatest(steps));
    }
  }

  toFlaw(direction) {
    const steps = this.flaws.map((flaw) => flaw.at).filter((at) => (direction > 0 ? at > this.cursor : at < this.cursor));
    if (steps.length > 0) {
      this.go(direction > 0 ? least(steps) : greatest(steps));
    }
  }

  select(track) {
    this.selected = track;
    this.timeline.mark(track);
    this.moved();
  }

  selectNext(direction) {
    const tracks = this.timeline.tracks;
    const now = tracks.indexOf(this.selected);
    const next = this.selected === null ? (direction > 0 ? 0 : tracks.length - 1) : now + direction;
    this.select(tracks[next] || null);
  }

  /** Puts the chosen row elsewhere. */
  move(direction) {
    if (this.selected !== null) {
      this.timeline.move(this.selected, direction);
    }
  }

  fold() {
    if (this.selected !== null) {
      this.timeline.groups.foldAround(this.selected);
    }
  }

  found(steps) {
    this.timeline.found = steps;
    this.search.arrive = true;
    this.timeline.redraw();
  }
}

function least(numbers) {
  return numbers.reduce((one, other) => Math.min(one, other));
}

function greatest(numbers) {
  return numbers.reduce((one, other) => Math.max(one, other));
}

/** A name that may be broken behind packages and the suite. */
function breakable(title) {
  const parts = title.split(/(?<=[#.])/);
  return element("span", {}, ...parts.flatMap((part) => [part, element("wbr")]));
}

/** All runs; one of them is shown. */
class Stories {
  constructor(data) {
    const colours = new Colours();
    this.data = data;
    this.colours = colours;
    this.arrangement = new Arrangement();
    this.arrangement.changed = () => this.moved();
    this.place = document.getElementById("story");
    this.list = document.getElementById("stories");
    const first = data.findIndex((story) => story.tone === "bad");
    if (data.length > 1) {
      this.buildList();
    }
    this.place.addEventListener("click", (event) => this.giveBack(event));
    this.show(Math.max(0, first));
  }

  buildList() {
    this.items = this.data.map((story, index) =>
      element("button", { type: "button", class: story.tone, onclick: () => this.show(index) }, element("span", { class: "dot" }), breakable(story.title)),
    );
    const filter = element("input", { type: "search", placeholder: "filter", "aria-label": "Filter runs", oninput: () => this.filter(filter.value) });
    this.list.append(filter, ...this.items);
    this.list.hidden = false;
    document.body.classList.add("several");
  }

  filter(text) {
    const wanted = text.toLowerCase();
    this.items.forEach((item, index) => {
      item.hidden = !this.data[index].title.toLowerCase().includes(wanted);
    });
  }

  show(index) {
    if (this.data.length === 0) {
      return;
    }
    this.index = index;
    this.current = new Story(this.data[index], this.colours, this.arrangement, () => this.moved());
    this.current.show(this.place);
    if (this.items) {
      this.items.forEach((item, each) => item.setAttribute("aria-current", each === index));
      this.items[index].scrollIntoView({ block: "nearest" });
    }
    const timeline = document.getElementById("timeline");
    if (timeline !== null) {
      timeline.focus({ preventScroll: true });
    }
  }

  /** A pointer that has used a button leaves the keys to the timeline; who goes from button to button by keys stays there. */
  giveBack(event) {
    const timeline = document.getElementById("timeline");
    if (timeline !== null && event.detail > 0 && event.target.closest("button") !== null && !document.getElementById("help").open) {
      timeline.focus({ preventScroll: true });
    }
  }

  /** Nobody is told before there is an address. */
  moved() {
    if (this.address) {
      this.address.follow(this.current);
    }
  }

  showNext(direction) {
    const next = this.index + direction;
    if (next >= 0 && next < this.data.length) {
      this.show(next);
    }
  }
}
