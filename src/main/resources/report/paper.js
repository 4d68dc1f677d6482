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
      rows.push(this.row(shortName(track), lane));
    }
    return element("div", { class: "timeline piece" }, ...rows);
  }

  row(name, lane) {
    return element("div", { class: "row" }, element("span", { class: "name" }, name), lane);
  }

  lane(style, height) {
    return shape("svg", { class: style, viewBox: `0 0 ${PIECE.width} ${height}`, "aria-hidden": "true" });
  }
}

function listenToPrinters(stories) {
  addEventListener("beforeprint", () => {
    if (stories.current && stories.current.paper) {
      stories.current.paper.draw();
    }
  });
}
