// The table beside an older one: what got better or worse on the runs that both have.

const SAID = { better: "better", worse: "worse", undecided: "" };

function against(older, index) {
  const about = facts([
    ["runs there", count(older.runs)],
    ["runs of both", count(older.pairs)],
    ["table there", older.table],
  ]);
  const remarks = older.remarks.map((each) => element("p", { class: "explained" }, each));
  const changes = older.events.filter((each) => each.better + each.worse > 0).map(changedSeeds);
  const parts = [about, ...remarks, eventsBeside(older.events), measuresBeside(older.measures), ...changes];
  return section(`against-${index}`, `Against ${older.name}`, ...parts.filter((part) => part !== null));
}

function beside(names, rows) {
  const head = element("tr", {}, ...names.map((each) => element("th", { scope: "col" }, each)));
  return element("div", { class: "panel beside" }, element("table", {}, element("thead", {}, head), element("tbody", {}, ...rows)));
}

function cells(tone, ...texts) {
  return element("tr", { class: tone }, ...texts.map((each) => element("td", {}, each)));
}

function eventsBeside(events) {
  const share = (each) => `${count(each.runs)} of ${count(each.known)}`;
  const rows = events.map((each) =>
    cells(TONES[each.decision] === "open" ? null : TONES[each.decision], each.name, share(each.before), share(each.now), count(each.better), count(each.worse), SAID[each.decision]),
  );
  return beside(["event", "before", "now", "better in", "worse in", "that is"], rows);
}

function measuresBeside(measures) {
  if (measures.length === 0) {
    return null;
  }
  const rows = measures.map((each) => cells(null, each.name, number(each.before), number(each.now), count(each.greater), count(each.smaller), each.differs ? "more than chance" : ""));
  return beside(["median", "before", "now", "greater in", "smaller in", "that is"], rows);
}

function changedSeeds(event) {
  const list = (title, changes) => {
    const lines = changes.map((each) => element("li", {}, [`seed ${each.seed}`, ...Object.entries(each.values).map(([name, value]) => `${name} ${value}`)].join(", ")));
    return lines.length === 0 ? null : element("div", {}, element("p", { class: "figures" }, title), element("ul", {}, ...lines));
  };
  const parts = [list("got worse, the first of them", event.firstWorse), list("got better, the first of them", event.firstBetter)];
  return element("details", { class: "panel beside" }, element("summary", {}, `${event.name}: where it changed`), ...parts.filter((part) => part !== null));
}
