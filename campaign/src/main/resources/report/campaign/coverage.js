// Which transitions were taken, in which states runs were, and what no run or no part came to.

/** So many parts are named at an item; a robot may have a thousand. */
const NAMED_PARTS = 8;

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
  const parts = all.automata.flatMap((each) => each.parts);
  const shared = all.automata.some((each) => each.parts.length > 1);
  return facts([
    ["transitions taken", `${count(all.taken)} of ${count(all.transitions)}`],
    ["states entered", `${count(all.visited)} of ${count(all.states)}`],
    ...(shared ? [["by each part", partly(parts.flatMap((each) => each.transitions), parts.flatMap((each) => each.states))]] : []),
    ["by", runs(all.runs)],
  ]);
}

function partly(transitions, states) {
  const some = (runs) => `${count(runs.filter((one) => one > 0).length)} of ${count(runs.length)}`;
  return `${some(transitions)} transitions, ${some(states)} states`;
}

/** What is missing comes first, and is open to be read. */
function automaton(each, all) {
  const amount = partly(each.transitions.map((one) => one.runs), each.states.map((one) => one.runs));
  const parts = each.parts.length > 1 ? each.parts : [];
  const states = each.states.map((one, i) => ({ ...one, text: `state ${one.name}`, coded: true, parts: parts.map((part) => ({ name: part.part, runs: part.states[i] })) }));
  const transitions = each.transitions.map((one, i) => ({ ...one, parts: parts.map((part) => ({ name: part.part, runs: part.transitions[i] })) }));
  const items = [...states, ...transitions];
  const isPartly = (one) => one.runs > 0 && one.parts.some((part) => part.runs === 0);
  const isWhole = (one) => one.runs > 0 && !isPartly(one);
  const rows = [...items.filter((one) => one.runs === 0), ...items.filter(isPartly), ...items.filter(isWhole)].map((one) => item(one, all, parts.length > 0));
  const summary = element("summary", {}, element("strong", {}, each.component), " ", element("span", { class: "figures" }, amount));
  const column = (text) => element("th", { scope: "col" }, text);
  const head = element("tr", {}, column("line"), column("runs"), ...(parts.length > 0 ? [column("runs of each part")] : []), column(each.file));
  return element("details", { open: !items.every(isWhole), class: "panel covered" }, summary, element("table", {}, element("thead", {}, head), element("tbody", {}, ...rows)));
}

function item(one, all, shared) {
  const how = one.runs > 0 ? `${count(one.runs)} of ${count(all)}` : one.coded ? "none" : "none: another one is always taken first";
  const cells = [element("td", {}, String(one.line)), element("td", {}, how)];
  if (shared) {
    cells.push(element("td", { class: "parts" }, ...(one.runs > 0 ? ofParts(one.parts) : [])));
  }
  return element("tr", { class: one.runs > 0 ? null : "missing" }, ...cells, element("td", {}, element("code", {}, one.text)));
}

/** Those that never came there first. */
function ofParts(parts) {
  const sorted = [...parts.filter((each) => each.runs === 0), ...parts.filter((each) => each.runs > 0)];
  const lines = sorted.slice(0, NAMED_PARTS).map((each) => element("div", { class: each.runs > 0 ? null : "never" }, `${each.name}: ${each.runs > 0 ? count(each.runs) : "none"}`));
  const rest = sorted.length - NAMED_PARTS;
  return rest > 0 ? [...lines, element("div", {}, `and ${count(rest)} more`)] : lines;
}
