// Numbers as people read them.

/** Three digits that say something; all of a whole number. */
function number(value) {
  if (value === undefined || value === null) {
    return "never";
  }
  return Number.isInteger(value) ? count(value) : plain(Number(value.toPrecision(3)));
}

/** Without an exponent, and without zeros at the end. */
function plain(value) {
  return value.toLocaleString("en-GB", { maximumFractionDigits: 12, useGrouping: Math.abs(value) >= 10000 });
}

function count(value) {
  return value.toLocaleString("en-GB");
}

function percent(share) {
  return plain(Number((share * 100).toPrecision(3))) + " %";
}

function runs(value) {
  return count(value) + (value === 1 ? " run" : " runs");
}

/** A part of the page with its heading. */
function section(id, title, ...children) {
  return element("section", { id, "aria-labelledby": id + "-title" }, element("h2", { id: id + "-title" }, title), ...children);
}

/** Names and values, side by side. */
function facts(pairs) {
  const list = element("dl", { class: "facts" });
  for (const [name, value] of pairs) {
    list.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
  }
  return list;
}
