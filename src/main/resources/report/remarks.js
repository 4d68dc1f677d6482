// What there is to say about a run: sentences, with the lines of models that they are about.

function remarks(story, go) {
  const list = story.remarks.map((remark) => {
    const item = element("li", { class: remark.tone }, element("p", {}, remark.text));
    if (remark.at !== undefined) {
      const label = `${story.unit} ${story.label(remark.at)}`;
      item.firstChild.append(" ", button(label, `Go to ${label}`, () => go(remark.at), { class: "link" }));
    }
    if (remark.place !== undefined) {
      item.append(excerpt(remark));
    }
    return item;
  });
  return element("ul", { class: "remarks", "aria-label": "Findings", hidden: list.length === 0 }, ...list);
}

function excerpt(remark) {
  const lines = remark.lines.map((line) =>
    element(
      "span",
      { class: "line" },
      element("span", { class: "number" }, String(line.number)),
      line.before,
      element("mark", {}, line.marked),
      line.after + "\n",
    ),
  );
  return element("div", { class: "excerpt" }, element("span", { class: "place" }, remark.place), element("pre", {}, ...lines));
}

/** What was asked, what that means, and what to try next. */
function facts(story) {
  const rows = story.facts.flatMap(({ label, text }) => [element("dt", {}, label), element("dd", {}, text)]);
  return element("dl", { class: "facts", "aria-label": "The question", hidden: rows.length === 0 }, ...rows);
}
