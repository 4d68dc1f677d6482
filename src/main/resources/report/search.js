// Finds steps by what is there: "fwd" wherever a value has it, "cmd = fwd" on one port only.

const TYPING = 120;

class Search {
  /** @param found takes the sorted steps that were found, and whether they are new */
  constructor(story, found, go) {
    this.story = story;
    this.report = found;
    this.go = go;
    this.steps = [];
    this.count = element("span", { class: "count", role: "status" });
    this.input = element("input", {
      type: "search",
      id: "search",
      placeholder: "find: fwd, or cmd = fwd",
      "aria-label": "Find a value, or port = value",
      spellcheck: "false",
      oninput: () => this.soon(),
      onkeydown: (event) => this.key(event),
    });
    this.element = element("span", { class: "search" }, this.input, this.count);
  }

  /** Takes what is typed from now on. */
  begin() {
    this.input.focus();
    this.input.select();
  }

  soon() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.run(), TYPING);
  }

  key(event) {
    if (event.key === "Enter") {
      clearTimeout(this.timer);
      this.run();
      this.next(event.shiftKey ? -1 : 1);
    } else if (event.key === "Escape") {
      this.input.value = "";
      this.run();
      document.getElementById("timeline").focus({ preventScroll: true });
    } else {
      return;
    }
    event.preventDefault();
  }

  run() {
    const query = this.input.value;
    if (query !== this.query) {
      this.query = query;
      this.steps = query.trim() === "" ? [] : findSteps(this.story.tracks, query);
      this.report(this.steps);
    }
    this.tell();
  }

  /** Goes to the next place, or to the one before; round and round. */
  next(direction) {
    const count = this.steps.length;
    if (count === 0) {
      return;
    }
    const here = firstAtLeast(this.steps, this.story.cursor);
    const isHere = this.steps[here] === this.story.cursor;
    const wanted = direction > 0 ? (isHere && !this.arrive ? here + 1 : here) : here - 1;
    this.arrive = false;
    this.go(this.steps[(wanted + count) % count]);
    this.tell();
  }

  tell() {
    if (!this.query || this.query.trim() === "") {
      this.count.textContent = "";
      return;
    }
    const here = firstAtLeast(this.steps, this.story.cursor);
    const isHere = this.steps[here] === this.story.cursor;
    const all = this.steps.length;
    this.count.textContent = all === 0 ? "none" : isHere ? `${here + 1} of ${all}` : `${all} found`;
  }
}

/** The steps at which a value begins that fits. */
function findSteps(tracks, query) {
  const [left, right] = query.toLowerCase().split(/=(.*)/s).map((text) => text.trim());
  const found = new Set();
  for (const track of tracks) {
    const name = track.name.toLowerCase();
    const named = right !== undefined && name.includes(left);
    const fits = track.values.map((value) => {
      const text = value.toLowerCase();
      return right === undefined ? text.includes(left) || name.includes(left) : (named && text.includes(right)) || text.includes(query.trim().toLowerCase());
    });
    for (let run = 0; run < track.count; run++) {
      if (track.codes[run] !== NOTHING && fits[track.codes[run]]) {
        found.add(track.starts[run]);
      }
    }
  }
  return Int32Array.from(found).sort();
}
