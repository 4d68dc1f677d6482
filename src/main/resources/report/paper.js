// The run as it is printed: paper cannot be moved, so all of it stands there, in pieces below each other.

const PIECE = { width: 560, most: 20, fewest: 5 };

/** More than a reader would turn pages for. */
const MOST_STEPS = 400;

class Paper {
  constructor(story) {
    this.story = story;
    this.element = element("div", { class: "paper-run" });
  }

  /** Draws it: only who prints needs it. */
  draw() {
    const { from, to } = this.range();
    const steps = this.stepsOfAPiece();
    const pieces = [];
    for (let step = from; step < to; step += steps) {
      pieces.push(this.piece(step, steps));
    }
    if (to - from < this.story.length) {
      const told = `${this.story.unit} ${from} to ${to - 1} of 0\u2013${this.story.length - 1}, around ${this.story.cursor}`;
      pieces.unshift(element("p", {}, told));
    }
    this.element.replaceChildren(...pieces);
  }

  /** All of it, or of a long run what is around the cursor. */
  range() {
    const { length, cursor } = this.story;
    if (length <= MOST_STEPS) {
      return { from: 0, to: length };
    }
    const from = clamp(cursor - MOST_STEPS / 2, 0, length - MOST_STEPS);
    return { from, to: from + MOST_STEPS };
  }

  /** As many as have room for what stands in them: on paper nobody can ask for the rest of a text. */
  stepsOfAPiece() {
    const texts = this.story.timeline.tracks.flatMap((track) => track.values);
    const longest = texts.reduce((length, text) => Math.max(length, text.length), 1);
    const { fewest, most } = { ...PIECE, ...this.story.onPaper };
    return clamp(Math.floor(PIECE.width / (longest * LETTER + 2 * PADDING + 2)), fewest, most);
  }

  piece(from, steps) {
    const view = new View(this.story.length);
    view.from = from;
    view.span = steps;
    view.width = PIECE.width;
    view.abbreviates = false;
    const ruler = this.lane("ruler", 27);
    ruler.append(...rulerShapes(view, this.story));
    const rows = [this.row(this.story.unit, ruler)];
    let group = "";
    for (const { track, flaws } of this.story.timeline.rows) {
      if (track.group !== group) {
        group = track.group;
        rows.push(element("div", { class: group.startsWith(PART) ? "part" : null }, element("div", { class: "group" }, group)));
      }
      const lane = this.lane("lane", LANE.height);
      drawLane(lane, track, view, this.story.colours, flaws);
      rows.push(this.row(this.name(track, view), lane));
      const rest = tellBeside(lane, track, view);
      if (rest.length > 0) {
        rows.push(this.row("", element("p", { class: "told" }, ...rest.map((told) => this.told(told)))));
      }
    }
    return element("div", { class: "timeline piece" }, ...rows);
  }

  /** Of a curve with its bounds. */
  name(track, view) {
    const bounds = `${track.least} to ${track.greatest}`;
    return element("span", {}, shortName(track), isCurve(track, view) ? element("small", {}, bounds) : null);
  }

  /** A value in words, and when it begins. */
  told({ step, text }) {
    return element("span", {}, element("b", {}, this.story.label(step)), "\u00a0" + text);
  }

  row(name, lane) {
    return element("div", { class: "row" }, element("span", { class: "name" }, name), lane);
  }

  lane(style, height) {
    return shape("svg", { class: style, viewBox: `0 0 ${PIECE.width} ${height}`, "aria-hidden": "true" });
  }
}

/** Writes what has no room in its box behind it, where silence follows for long enough; answers all that has no room there either. */
function tellBeside(lane, track, view) {
  const rest = [];
  const end = isCurve(track, view) ? view.from : Math.min(view.from + view.span, view.length);
  const x = (step) => clamp(view.x(step), 0, view.width);
  for (let step = view.from; step < end && track.count > 0; step = track.starts[track.runAt(step) + 1]) {
    const run = track.runAt(step);
    const [from, to] = [x(track.starts[run]), x(track.starts[run + 1])];
    const text = track.codes[run] === NOTHING ? "" : track.values[track.codes[run]];
    if (whole(text, to - from - 2 * PADDING) === text) {
      continue;
    }
    const isBeforeSilence = run + 1 < track.count && track.codes[run + 1] === NOTHING;
    const room = isBeforeSilence ? x(track.starts[run + 2]) - to : 0;
    if (whole(text, room - PADDING) === text) {
      lane.append(shape("text", { class: "beside-box", x: round(to + 2), y: LANE.height / 2 + 4 }, text));
    } else {
      rest.push({ step: track.starts[run], text });
    }
  }
  return rest;
}

function listenToPrinters(stories) {
  addEventListener("beforeprint", () => {
    if (stories.current && stories.current.paper) {
      stories.current.paper.draw();
    }
  });
}
