// Which transitions were taken, in which states runs were, and what no run came to.

function coverage(answer) {
  const all = answer.coverage;
  if (all.runs === 0 && all.jars.length === 0) {
    return null;
  }
  const parts = all.runs === 0 ? [] : [covered(all), ...all.automata.map((each) => automaton(each, all.runs))];
  const jars = all.jars.map((each) => element("p", { class: "explained" }, `Nobody knows what ${each} covers: it was given without models.`));
  return section("coverage", "What was covered", ...parts, ...jars);
}

function covered(all) {
  return facts([
    ["transitions taken", `${count(all.taken)} of ${count(all.transitions)}`],
    ["states entered", `${count(all.visited)} of ${count(all.states)}`],
    ["by", runs(all.runs)],
  ]);
}

/** What is missing comes first, and is open to be read. */
function automaton(each, all) {
  const taken = each.transitions.filter((one) => one.runs > 0).length;
  const visited = each.states.filter((one) => one.runs > 0).length;
  const isWhole = taken === each.transitions.length && visited === each.states.length;
  const amount = `${taken} of ${each.transitions.length} transitions, ${visited} of ${each.states.length} states`;
  const summary = element("summary", {}, element("strong", {}, each.component), " ", element("span", { class: "figures" }, amount));
  const items = [...each.states.map((one) => ({ ...one, text: `state ${one.name}`, coded: true })), ...each.transitions];
  const rows = [...items.filter((one) => one.runs === 0), ...items.filter((one) => one.runs > 0)].map((one) => item(one, all));
  const head = element("tr", {}, element("th", { scope: "col" }, "line"), element("th", { scope: "col" }, "runs"), element("th", { scope: "col" }, each.file));
  return element("details", { open: !isWhole, class: "panel covered" }, summary, element("table", {}, element("thead", {}, head), element("tbody", {}, ...rows)));
}

function item(one, all) {
  const how = one.runs > 0 ? `${count(one.runs)} of ${count(all)}` : one.coded ? "none" : "none: another one is always taken first";
  return element("tr", { class: one.runs > 0 ? null : "missing" }, element("td", {}, String(one.line)), element("td", {}, how), element("td", {}, element("code", {}, one.text)));
}
