// Where the numbers of each measure are.

const TICKS = 5;

class Bins {
  constructor(measure) {
    this.measure = measure;
    this.isEach = measure.whole && measure.width <= 1;
    this.length = measure.width * measure.bins.length;
  }

  /** In percent of the axis; a whole number that has a bin of its own is in the middle of it. */
  at(value) {
    if (this.length === 0) {
      return 50;
    }
    return clamp((100 * (value - this.measure.from + (this.isEach ? 0.5 : 0))) / this.length, 0, 100);
  }

  edge(index) {
    return Number((this.measure.from + index * this.measure.width).toPrecision(12));
  }

  label(index) {
    return this.isEach || this.length === 0 ? number(this.edge(index)) : `${number(this.edge(index))} to ${number(this.edge(index + 1))}`;
  }

  /** Numbers to write below. */
  ticks() {
    const last = this.measure.bins.length - (this.isEach || this.length === 0 ? 1 : 0);
    const step = Math.max(1, Math.ceil(last / TICKS));
    return Array.from({ length: Math.floor(last / step) + 1 }, (_, i) => this.edge(i * step));
  }
}

function bars(measure, bins) {
  const most = Math.max(...measure.bins);
  const width = 100 / measure.bins.length;
  return measure.bins.map((size, index) => {
    const height = (86 * size) / most;
    const isAlone = measure.width === 0;
    const box = { x: (isAlone ? 45 : index * width + width * 0.05) + "%", width: (isAlone ? 10 : width * 0.9) + "%", y: 90 - height + "%", height: height + "%" };
    return shape("rect", { class: "bin", ...box }, shape("title", {}, `${bins.label(index)}: ${runs(size)}`));
  });
}

/** Half of the runs lie in the box; the line in it is the median. */
function quartiles(measure, bins) {
  const marks = [];
  if (measure.lower !== undefined) {
    const low = bins.at(measure.lower);
    const high = measure.upper === undefined ? 100 : bins.at(measure.upper);
    marks.push(shape("rect", { class: "half", x: low + "%", width: Math.max(0.4, high - low) + "%", y: "93%", height: "6%" }));
  }
  if (measure.median !== undefined) {
    const at = bins.at(measure.median) + "%";
    marks.push(shape("line", { class: "median", x1: at, x2: at, y1: "91%", y2: "100%" }));
  }
  for (const bound of measure.bounds) {
    const at = bins.at(bound.value) + "%";
    marks.push(shape("line", { class: "bound", x1: at, x2: at, y1: 0, y2: "100%" }, shape("title", {}, `required: ${bound.side} ${number(bound.value)}`)));
  }
  return marks;
}

function histogram(measure, made) {
  const heading = element("figcaption", {}, element("strong", {}, measure.name), element("span", {}, measure.meaning));
  if (measure.bins.length === 0) {
    const none = measure.never > 0 ? `Never, in ${runs(measure.never)}.` : "No run has a number.";
    return element("figure", {}, heading, element("p", { class: "figures" }, none));
  }
  const bins = new Bins(measure);
  const told = `least ${number(measure.least)}, median ${number(measure.median)}, greatest ${number(measure.greatest)}`;
  const picture = shape("svg", { class: "histogram", role: "img", "aria-label": told }, ...bars(measure, bins), ...quartiles(measure, bins));
  const axis = shape("svg", { class: "scale", "aria-hidden": "true" });
  bins.ticks().forEach((tick) => {
    const at = bins.at(tick);
    const anchor = at < 4 ? "start" : at > 96 ? "end" : "middle";
    axis.append(shape("text", { x: at + "%", y: 12, "text-anchor": anchor }, number(tick)));
  });
  const left = [];
  if (measure.never > 0) {
    left.push(`never in ${runs(measure.never)}`);
  }
  if (measure.known < made) {
    left.push(`no number in ${runs(made - measure.known)}`);
  }
  return element("figure", {}, heading, picture, axis, element("p", { class: "figures" }, [told, ...left].join("; ")));
}

function histograms(answer) {
  if (answer.measures.length === 0) {
    return null;
  }
  const explained = element("p", { class: "explained" }, "Below the bars: the half of the runs in the middle, with the median.");
  return section("measures", "What was measured", element("div", { class: "figures-grid" }, ...answer.measures.map((each) => histogram(each, answer.made))), explained);
}
