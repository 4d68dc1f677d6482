// Draws a track's lane: only what is to be seen. Where runs are narrower than pixels, one column
// stands for many; the next one is found by halving, so a lane costs what its width costs.

const LANE = { height: 24, top: 3, bottom: 21 };
const COLUMN = 2;
const LETTER = 6.7;
const PADDING = 5;

/** More numbers than that are a curve. */
const MOST_IN_WORDS = 12;

function drawLane(lane, track, view, colours, flaws) {
  const shapes = [];
  const paths = new Map();
  if (isCurve(track, view)) {
    drawCurve(shapes, track, view);
  } else {
    drawBoxes(shapes, paths, track, view, colours);
  }
  for (const [style, path] of paths) {
    shapes.push(shape("path", { class: style, d: path.join("") }));
  }
  for (const flaw of flaws) {
    const width = Math.max(3, view.pixelsPerStep);
    if (flaw.at + 1 >= view.from && flaw.at <= view.from + view.span) {
      const x = view.x(flaw.at);
      shapes.push(shape("rect", { class: "flaw", x: x + 0.75, y: 1, width: width - 1.5, height: LANE.height - 2, rx: 3 }));
    }
  }
  lane.replaceChildren(...shapes);
}

/** Whether it is numbers that have no room as texts. Where nothing may be left out, a few find room beside their boxes. */
function isCurve(track, view) {
  return track.numbers !== null && view.pixelsPerStep < 24 && (view.abbreviates || messagesIn(track, view) > MOST_IN_WORDS);
}

function messagesIn(track, view) {
  const last = track.runAt(Math.min(view.from + view.span, view.length) - 1);
  return track.codes.subarray(track.runAt(view.from), last + 1).filter((code) => code !== NOTHING).length;
}

/** A box for each run with its text, columns of colour where boxes have no room. */
function drawBoxes(shapes, paths, track, view, colours) {
  const end = Math.min(view.from + view.span, view.length);
  let step = view.from;
  while (step < end && track.count > 0) {
    const run = track.runAt(step);
    const from = view.x(track.starts[run]);
    const to = view.x(track.starts[run + 1]);
    const code = track.codes[run];
    if (to - from >= COLUMN * 2) {
      drawBox(shapes, paths, track, code, Math.max(from, -9), Math.min(to, view.width + 9), view, colours);
      step = track.starts[run + 1];
    } else {
      const x = Math.floor(view.x(step) / COLUMN) * COLUMN;
      if (code !== NOTHING) {
        addColumn(paths, "run " + colours.of(track, code), x, COLUMN);
      }
      const next = view.from + (x + COLUMN) / view.pixelsPerStep;
      step = next > step ? next : step + 1;
    }
  }
}

function drawBox(shapes, paths, track, code, from, to, view, colours) {
  if (code === NOTHING) {
    const middle = LANE.height / 2;
    add(paths, "silence", `M${round(from + 1)} ${middle}H${round(to - 1)}`);
    return;
  }
  const width = to - from - 1;
  const style = "run " + colours.of(track, code);
  if (width < 8) {
    addColumn(paths, style, from + 0.5, width);
    return;
  }
  const box = { class: style, x: round(from + 0.5), y: LANE.top, width: round(width), height: LANE.bottom - LANE.top, rx: 4 };
  shapes.push(shape("rect", box));
  // What begins left of the window says its name where it can be read.
  const left = Math.max(from, 0) + PADDING;
  const room = Math.min(to, view.width) - PADDING - left;
  const text = view.abbreviates ? fitting(track.values[code], room) : whole(track.values[code], room);
  if (text !== "") {
    shapes.push(shape("text", { x: round(left), y: LANE.height / 2 + 4 }, text));
  }
}

/** How many letters there is room for. */
function lettersIn(width) {
  return Math.floor((width + 1) / LETTER);
}

/** A text or nothing. */
function whole(text, width) {
  return text.length <= lettersIn(width) ? text : "";
}

function fitting(text, width) {
  const letters = lettersIn(width);
  if (text.length <= letters) {
    return text;
  }
  return letters < 2 ? "" : text.slice(0, letters - 1) + "\u2026";
}

function addColumn(paths, style, x, width) {
  add(paths, style, `M${round(x)} ${LANE.top}h${round(width)}V${LANE.bottom}h-${round(width)}z`);
}

function add(paths, style, path) {
  if (!paths.has(style)) {
    paths.set(style, []);
  }
  paths.get(style).push(path);
}

/** Numbers as a curve of steps; where there are more of them than pixels, as the band they fill. */
function drawCurve(shapes, track, view) {
  if (track.count === 0) {
    return;
  }
  const scale = (LANE.bottom - LANE.top - 2) / (track.greatest - track.least);
  const height = (code) => round(LANE.bottom - 1 - (track.numbers[code] - track.least) * scale);
  const first = track.runAt(view.from);
  const last = track.runAt(Math.min(view.from + view.span, view.length) - 0.001);
  const isDense = last - first > view.width;
  const path = isDense ? band(track, view, first, last, height) : curve(track, view, first, last, height);
  shapes.push(shape("path", { class: isDense ? "band" : "curve", d: path.join("") }));
}

function curve(track, view, first, last, height) {
  const path = [];
  let open = false;
  for (let run = first; run <= last; run++) {
    const code = track.codes[run];
    if (code === NOTHING) {
      open = false;
      continue;
    }
    const from = Math.max(view.x(track.starts[run]), -2);
    const to = Math.min(view.x(track.starts[run + 1]), view.width + 2);
    path.push(open ? `V${height(code)}` : `M${round(from)} ${height(code)}`, `H${round(to)}`);
    open = true;
  }
  return path;
}

/** For every column of pixels, from the least to the greatest number in it. */
function band(track, view, first, last, height) {
  const path = [];
  let column = null;
  let top = 0;
  let bottom = 0;
  const flush = () => {
    if (column !== null) {
      path.push(`M${column + 0.5} ${top - 0.5}V${bottom + 0.5}`);
    }
  };
  for (let run = first; run <= last; run++) {
    const code = track.codes[run];
    if (code === NOTHING) {
      continue;
    }
    const here = Math.max(0, Math.floor(view.x(track.starts[run])));
    const y = height(code);
    if (here !== column) {
      flush();
      column = here;
      top = bottom = y;
    }
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  flush();
  return path;
}

function round(value) {
  return Math.round(value * 10) / 10;
}
