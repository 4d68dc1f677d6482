// What is so at one step, as text: every track's value, what it was before, since when, and why.

class Moment {
  /** @param go moves the cursor to a step */
  constructor(story, colours, go) {
    this.story = story;
    this.colours = colours;
    this.go = go;
    this.rows = [];
    this.flaws = element("div", { class: "flaw-texts" });
    this.element = element("section", { class: "moment", "aria-label": "Values" }, this.flaws, this.table());
  }

  table() {
    const table = element("table");
    let body = null;
    let group = null;
    for (const track of this.story.tracks.filter((each) => each.kind !== "path")) {
      if (track.group !== group) {
        group = track.group;
        body = element("tbody", {}, element("tr", {}, element("th", { colspan: 3, scope: "rowgroup", class: group.startsWith(PART) ? "part" : null }, group)));
        table.append(body);
      }
      body.append(track.kind === "reason" ? this.reason(track) : this.row(track));
    }
    return table;
  }

  row(track) {
    const value = element("td", { class: "value" });
    const since = element("td", { class: "since" });
    this.rows.push({ track, value, since });
    return element("tr", { class: track.kind }, element("th", { scope: "row", title: track.name }, shortName(track)), value, since);
  }

  reason(track) {
    const value = element("td", { class: "because", colspan: 2 });
    this.rows.push({ track, value, since: null });
    return element("tr", { class: "reason" }, element("td"), value);
  }

  show(step) {
    for (const row of this.rows) {
      if (row.since === null) {
        row.value.textContent = row.track.textAt(step) || "";
      } else {
        this.showValue(row, step);
      }
    }
    const flaws = this.story.flaws.filter((flaw) => flaw.at === step);
    this.flaws.replaceChildren(...flaws.map((flaw) => element("p", { class: "flaw-text" }, flaw.text)));
  }

  showValue({ track, value, since }, step) {
    const now = track.textAt(step);
    const before = track.textAt(step - 1);
    const flawed = this.story.flaws.some((flaw) => flaw.at === step && flaw.track === track.name);
    value.classList.toggle("flawed", flawed);
    value.replaceChildren(now === null ? element("span", { class: "nothing" }, "\u2013") : this.chip(track, step, now));
    if (track.kind !== "port" && before !== null && before !== now) {
      value.prepend(element("span", { class: "before" }, before + " \u2192 "));
    }
    const start = track.count === 0 ? step : track.sinceWhen(step);
    const told = now !== null && start < step && track.kind !== "port";
    since.replaceChildren(
      ...(told ? [button("since " + this.story.label(start), `Go to ${this.story.unit} ${start}`, () => this.go(start), { class: "link" })] : []),
    );
  }

  chip(track, step, text) {
    return element("span", { class: "chip " + this.colours.of(track, track.codeAt(step)) }, text);
  }
}
