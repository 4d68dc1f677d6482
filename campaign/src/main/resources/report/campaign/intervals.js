// How often things happened: estimate and 95 % interval on one logarithmic axis from rare to always.

class ShareAxis {
  constructor(events) {
    const smallest = events
      .flatMap((each) => [each.low > 0 ? each.low : each.high, ...each.bounds.map((bound) => bound.value)])
      .filter((share) => share > 0);
    this.decades = Math.max(1, Math.ceil(-Math.log10(Math.min(0.1, ...smallest)) + 0.3));
  }

  /** In percent of its length; what is rarer than its beginning stands there. */
  at(share) {
    return share <= 0 ? 0 : clamp(100 * (1 + Math.log10(share) / this.decades), 0, 100);
  }

  ticks() {
    return Array.from({ length: this.decades + 1 }, (_, i) => 10 ** (i - this.decades));
  }
}

function bar(event, axis) {
  const tone = event.name === "goal" ? "wanted" : "unwanted";
  const low = axis.at(event.low);
  const picture = shape("svg", { class: "bar " + tone, role: "img", "aria-label": interval(event) });
  for (const tick of axis.ticks()) {
    picture.append(shape("line", { class: "tick", x1: axis.at(tick) + "%", x2: axis.at(tick) + "%", y1: 0, y2: "100%" }));
  }
  picture.append(shape("rect", { class: "interval", x: low + "%", width: Math.max(0.6, axis.at(event.high) - low) + "%", y: 7, height: 10, rx: 3 }));
  if (event.share !== undefined) {
    const at = axis.at(event.share) + "%";
    picture.append(shape("circle", { class: event.share > 0 ? "estimate" : "estimate none", cx: at, cy: 12, r: 5 }));
  }
  for (const bound of event.bounds) {
    const at = axis.at(bound.value) + "%";
    const title = shape("title", {}, `required: ${bound.side} ${percent(bound.value)}`);
    picture.append(shape("line", { class: "bound", x1: at, x2: at, y1: 0, y2: 24 }, title));
  }
  return picture;
}

function interval(event) {
  return `surely ${percent(event.low)} to ${percent(event.high)}`;
}

function scale(axis) {
  const picture = shape("svg", { class: "scale", "aria-hidden": "true" });
  axis.ticks().forEach((tick, index) => {
    const anchor = index === 0 ? "start" : index === axis.decades ? "end" : "middle";
    picture.append(shape("text", { x: axis.at(tick) + "%", y: 12, "text-anchor": anchor }, percent(tick)));
  });
  return picture;
}

function intervals(answer) {
  const axis = new ShareAxis(answer.events);
  const rows = answer.events.map((each) =>
    element(
      "div",
      { class: "event" },
      element("div", { class: "what" }, element("strong", {}, each.name), element("span", {}, each.meaning)),
      element(
        "div",
        { class: "share" },
        element("strong", {}, each.share === undefined ? "-" : percent(each.share)),
        element("span", {}, `${count(each.runs)} of ${runs(each.known)}`),
      ),
      element("div", { class: "graph" }, bar(each, axis), element("span", { class: "figures" }, interval(each))),
    ),
  );
  const foot = element("div", { class: "event" }, element("span", {}), element("span", {}), element("div", { class: "graph" }, scale(axis)));
  const explained = element("p", { class: "explained" }, "Dots are shares of the runs, bars where the probability surely is (95 %), whatever runs without an answer would have done, dashed lines what is required. Each step of the axis is ten times as often.");
  return section("events", "What happened, and how often", element("div", { class: "panel" }, ...rows, foot), explained);
}
