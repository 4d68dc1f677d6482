// Runs to look at, each with the command that makes it again.

function command(text) {
  const code = element("code", { tabindex: 0 }, text);
  const copy = button("Copy", "Copy the command", () => {
    getSelection().selectAllChildren(code);
    const told = (word) => {
      copy.textContent = word;
    };
    navigator.clipboard?.writeText(text).then(() => told("Copied"), () => told("Selected"));
  });
  return element("p", { class: "play" }, code, copy);
}

function values(all) {
  return Object.entries(all).map(([name, value]) => `${name} ${value}`);
}

function notable(answer) {
  if (answer.notable.length === 0) {
    return null;
  }
  const items = answer.notable.map((each) => shown(each, `run ${count(each.run)}, seed ${each.seed}`));
  return section("runs", "Runs to look at", element("ol", { class: "runs" }, ...items));
}

/** A run with its values, what it answered, and its command. */
function shown(run, title) {
  return element(
    "li",
    {},
    element(
      "p",
      {},
      element("strong", {}, title),
      ...run.events.map((name) => element("span", { class: "event-chip " + (name === "goal" ? "good" : "bad") }, name)),
    ),
    element("p", { class: "figures" }, [...values(run.values), ...Object.entries(run.measures).map(([name, value]) => `${name} ${number(value)}`)].join(", ")),
    command(run.command),
  );
}

function compared(answer) {
  const all = answer.compared;
  if (all === undefined) {
    return null;
  }
  const same = all.pairs - all.better - all.worse;
  const numbers = facts([
    ["better", count(all.better)],
    ["worse", count(all.worse)],
    ["the same", count(same)],
    ["pairs", count(all.pairs)],
  ]);
  const said = element("p", { class: "explained" }, `By ${all.event}: ${all.parameter} ${all.after} instead of ${all.before}, on the same seeds.`);
  return section(
    "compared",
    "What changed",
    said,
    numbers,
    element("div", { class: "changes" }, changes("Got worse", all.firstWorse, all.worse), changes("Got better", all.firstBetter, all.better)),
  );
}

function changes(title, kept, total) {
  const heading = element("h3", {}, kept.length < total ? `${title}: the first ${kept.length} of ${count(total)}` : title);
  if (total === 0) {
    return element("div", {}, heading, element("p", { class: "figures" }, "None."));
  }
  const items = kept.map((each) => {
    const told = [`seed ${each.seed}`, ...values(each.values)].join(", ");
    return element("details", {}, element("summary", {}, told), element("p", { class: "figures" }, "before"), command(each.before), element("p", { class: "figures" }, "after"), command(each.after));
  });
  return element("div", {}, heading, ...items);
}
