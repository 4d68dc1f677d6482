// What was asked, and what is said of it.

const TONES = { holds: "good", better: "good", fails: "bad", worse: "bad", undecided: "open" };

function asked(answer) {
  const made = answer.runs < answer.planned ? `${count(answer.runs)}, decided before the ${count(answer.planned)} planned` : count(answer.runs);
  const pairs = [
    ["world", answer.world],
    ["runs", made],
    ["seeds", answer.firstSeed === answer.lastSeed ? String(answer.firstSeed) : `${answer.firstSeed} to ${answer.lastSeed}`],
  ];
  if (answer.impossible > 0) {
    pairs.push(["without a world", count(answer.impossible)]);
  }
  if (answer.givenUp > 0) {
    pairs.push(["given up", count(answer.givenUp)]);
  }
  pairs.push(...answer.parameters.map((each) => [each.name, each.values]), ["table", answer.table]);
  return facts(pairs);
}

function verdicts(answer) {
  if (answer.verdicts.length === 0) {
    return null;
  }
  const items = answer.verdicts.map((each) => {
    const isTie = !each.required && each.decision === "undecided";
    const word = isTie ? "no difference" : each.decision;
    return element(
      "li",
      { class: isTie ? null : TONES[each.decision] },
      element("p", {}, element("span", { class: "word" }, word), " ", element("strong", {}, each.subject)),
      element("p", { class: "figures" }, each.because),
    );
  });
  return section("verdicts", "What was required", element("ul", { class: "remarks" }, ...items));
}
