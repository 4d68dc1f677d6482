// How rare it is to come near, level by level: each row has the share of its own runs, and the dot how probable it is to come
// there from the beginning.

function rare(answer) {
  const all = answer.rare;
  if (all === undefined) {
    return null;
  }
  const chances = [];
  all.levels.reduce((chance, level) => {
    chances.push((chance * level.reached) / level.runs);
    return chances[chances.length - 1];
  }, 1);
  const last = all.levels.length - 1;
  const stages = all.levels.map((level, index) => ({
    name: "within",
    share: chances[index],
    // Of the levels between nothing is claimed.
    low: index === last && all.low !== undefined ? all.low : chances[index],
    high: index === last && all.high !== undefined ? all.high : chances[index],
    bounds: [],
  }));
  const axis = new ShareAxis(stages);
  const rows = all.levels.map((level, index) => stage(level, stages[index], axis, all, index === 0));
  const foot = element("div", { class: "event" }, element("span", {}), element("span", {}), element("div", { class: "graph" }, scale(axis)));
  const nearest = all.nearest === undefined ? [] : [element("ol", { class: "runs" }, shown(all.nearest, "the run that came nearest"))];
  const explained = element("p", { class: "explained" }, "Runs of a level begin where runs of the level before have reached it. Dots are the products of the shares so far, on an axis each step of which is ten times as often; the bar is where the probability of the last level surely is (95 %). A family is what goes back to one run of the first level: where few came there, little is known.");
  return section("rare", "How rare it is", element("p", { class: "said" }, rarity(answer, all)), element("div", { class: "panel" }, ...rows, foot), explained, ...nearest);
}

function stage(level, stageOf, axis, all, isFirst) {
  const share = level.reached / level.runs;
  return element(
    "div",
    { class: "event" },
    element("div", { class: "what" }, element("strong", {}, `${count(level.level)} mm`), element("span", {}, isFirst ? "from the beginning" : "from the level before")),
    element("div", { class: "share" }, element("strong", {}, percent(share)), element("span", {}, `${count(level.reached)} of ${runs(level.runs)}`)),
    element("div", { class: "graph" }, bar(stageOf, axis), element("span", { class: "figures" }, `so far ${percent(stageOf.share)}`)),
  );
}

function rarity(answer, all) {
  const asked = `${all.measure} of ${count(all.asked)} mm`;
  if (all.givenUp > 0) {
    return `${asked}: not known, as ${count(all.givenUp)} of ${runs(all.runs)} were given up.`;
  }
  if (all.probability === undefined) {
    return `${asked}: not known, as too few runs have a world.`;
  }
  if (all.families === 0) {
    return `${asked}: none of ${runs(all.runs)} came there; the probability is surely (95 %) at most ${percent(all.high)}.`;
  }
  return `${asked}: probability ${percent(all.probability)}, surely (95 %) ${percent(all.low)} to ${percent(all.high)}, by ${runs(all.runs)}; ${count(all.families)} ${all.families === 1 ? "family" : "families"} came there.`;
}
