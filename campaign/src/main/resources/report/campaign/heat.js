// A map over two parameters: which values go wrong. Arrow keys go from cell to cell.

const PARTS = { known: 0, least: 1, mean: 2, greatest: 3 };
/** Cells in which a number can be read. */
const READABLE = 10;
/** Columns whose names are written across. */
const ROOMY = 4;

class Heat {
  constructor(maps) {
    this.maps = maps;
    this.parameters = [...new Set(maps.flatMap((map) => [map.x, map.y]))].filter((name) => name !== "");
    this.x = maps[0].x;
    this.y = maps[0].y;
    this.question = telling(maps[0].layers).name;
    this.part = this.layer.event ? "mean" : "least";
    this.place = null;
    this.grid = element("div", { class: "heat-grid" });
    this.legend = element("p", { class: "legend" });
    this.readout = element("p", { class: "readout", "aria-live": "polite" });
    this.controls = element("div", { class: "toolbar" });
    this.show();
  }

  get map() {
    return this.maps.find((map) => (map.x === this.x && map.y === this.y) || (map.x === this.y && map.y === this.x));
  }

  get layer() {
    return this.map.layers.find((layer) => layer.name === this.question);
  }

  /** What the map knows of a cell, whichever of its parameters is across. */
  cell(column, row) {
    const map = this.map;
    const isTurned = map.x !== this.x;
    const index = isTurned ? column * map.columns.length + row : row * map.columns.length + column;
    const [known, least, mean, greatest] = this.layer.cells.slice(4 * index, 4 * index + 4);
    return { runs: map.runs[index], known, least, mean, greatest };
  }

  get columns() {
    return this.map.x === this.x ? this.map.columns : this.map.rows;
  }

  get rows() {
    return this.map.x === this.x ? this.map.rows : this.map.columns;
  }

  show() {
    this.controls.replaceChildren(...this.choices());
    const shown = this.values();
    this.low = this.layer.event ? 0 : Math.min(...shown);
    this.high = Math.max(...shown, this.layer.event ? Number.MIN_VALUE : -Infinity);
    this.grid.replaceChildren(this.table());
    this.showLegend(shown.length > 0);
    this.readout.textContent = "Point at a cell, or go to the map with Tab and to its cells with the arrow keys.";
  }

  values() {
    const all = [];
    for (let row = 0; row < this.rows.length; row++) {
      for (let column = 0; column < this.columns.length; column++) {
        const cell = this.cell(column, row);
        if (cell.known > 0) {
          all.push(cell[this.part]);
        }
      }
    }
    return all;
  }

  choices() {
    const questions = this.map.layers.map((layer) => [layer.name, layer.event ? "how often: " + layer.meaning : layer.meaning]);
    const all = [this.choice("question", "Show", questions, (value) => this.ask(value))];
    if (!this.layer.event) {
      const parts = [["least", "least"], ["mean", "mean"], ["greatest", "greatest"]];
      all.push(this.choice("part", "of each cell the", parts, (value) => (this.part = value)));
    }
    if (this.parameters.length > 1) {
      const names = this.parameters.map((name) => [name, name]);
      all.push(this.choice("x", "across", names, (value) => this.turn("x", "y", value)));
      all.push(this.choice("y", "up", names, (value) => this.turn("y", "x", value)));
    }
    return all;
  }

  choice(field, label, options, choose) {
    const select = element("select", { id: "heat-" + field }, ...options.map(([value, text]) => element("option", { value, selected: value === this[field] }, text)));
    select.addEventListener("change", () => {
      choose(select.value);
      this.show();
      document.getElementById("heat-" + field).focus();
    });
    return element("label", {}, element("span", {}, label), select);
  }

  ask(question) {
    this.question = question;
    this.part = this.layer.event ? "mean" : this.part;
  }

  /** Who takes the parameter of the other axis gives it the own one. */
  turn(axis, other, value) {
    if (this[other] === value) {
      this[other] = this[axis];
    }
    this[axis] = value;
  }

  table() {
    const isReadable = this.columns.length <= READABLE;
    const body = [];
    for (let row = this.rows.length - 1; row >= 0; row--) {
      const cells = this.columns.map((_, column) => this.field(column, row, isReadable));
      body.push(element("tr", {}, element("th", { scope: "row", title: this.rows[row] }, begin(this.rows[row])), ...cells));
    }
    const heads = this.columns.map((label) => element("th", { scope: "col", title: label }, element("span", {}, begin(label))));
    const caption = element("caption", {}, `${this.y === "" ? "by " + this.x : `${this.x} across, ${this.y} upwards`}: ${this.shown()}`);
    const looks = (isReadable ? " readable" : "") + (this.columns.length <= ROOMY ? " roomy" : "");
    return element("table", { class: "heat" + looks, onkeydown: (event) => this.key(event) }, caption, this.widths(), element("tbody", {}, ...body), element("tfoot", {}, element("tr", {}, element("td", {}), ...heads)));
  }

  /** What the cells say; on paper there is no choice that does. */
  shown() {
    return this.layer.event ? `percent of runs in which ${this.layer.meaning}` : `${this.part} ${this.layer.name} (${this.layer.meaning})`;
  }

  /** Names of rows get what they need, as far as there is room; cells share the rest. */
  widths() {
    const names = element("col", {});
    const longest = Math.max(...this.rows.map((label) => begin(label).length));
    names.style.width = clamp(0.5 * longest + 1, 2.2, 9) + "rem";
    return element("colgroup", {}, names, ...this.columns.map(() => element("col", {})));
  }

  field(column, row, isReadable) {
    const cell = this.cell(column, row);
    const isFirst = column === 0 && row === this.rows.length - 1;
    const text = cell.known === 0 ? "" : plain(Number((this.layer.event ? 100 * cell.mean : cell[this.part]).toPrecision(this.layer.event ? 2 : 3)));
    const field = element("td", { tabindex: isFirst ? 0 : -1, "data-column": column, "data-row": row, "aria-label": this.told(column, row) }, isReadable ? text : "");
    if (cell.known === 0) {
      field.className = "empty";
    } else {
      const share = this.high > this.low ? (cell[this.part] - this.low) / (this.high - this.low) : 0;
      field.className = this.hue() + (share > 0.55 ? " strong" : "");
      field.style.setProperty("--share", Math.round(6 + 94 * share) + "%");
    }
    field.addEventListener("pointerenter", () => this.tell(column, row));
    field.addEventListener("focus", () => this.tell(column, row));
    return field;
  }

  hue() {
    return this.layer.event ? (this.question === "goal" ? "wanted" : "unwanted") : "amount";
  }

  told(column, row) {
    const cell = this.cell(column, row);
    const place = `${this.x} ${this.columns[column]}` + (this.y === "" ? "" : `, ${this.y} ${this.rows[row]}`);
    if (cell.runs === 0) {
      return `${place}: no run`;
    }
    if (this.layer.event) {
      return `${place}: ${count(Math.round(cell.mean * cell.known))} of ${runs(cell.runs)}, ${percent(cell.mean)}`;
    }
    const numbers = cell.known === 0 ? "no number" : `${number(cell.mean)} in the mean, from ${number(cell.least)} to ${number(cell.greatest)}`;
    const less = cell.known < cell.runs && cell.known > 0 ? `, of ${count(cell.known)} that have a number` : "";
    return `${place}: ${runs(cell.runs)}, ${numbers}${less}`;
  }

  tell(column, row) {
    this.readout.textContent = this.told(column, row);
  }

  showLegend(isAny) {
    const shown = (value) => (this.layer.event ? percent(value) : number(value));
    const ramp = element("span", { class: "ramp " + this.hue() });
    const ends = isAny ? [shown(this.low), ramp, shown(this.layer.event && this.high < 1e-300 ? 0 : this.high)] : [];
    this.legend.replaceChildren(...ends);
  }

  key(event) {
    const from = event.target.closest("td");
    const [right, up] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] || [0, 0];
    if (from === null || (right === 0 && up === 0)) {
      return;
    }
    const column = clamp(Number(from.dataset.column) + right, 0, this.columns.length - 1);
    const row = clamp(Number(from.dataset.row) + up, 0, this.rows.length - 1);
    const to = this.grid.querySelector(`td[data-column="${column}"][data-row="${row}"]`);
    from.tabIndex = -1;
    to.tabIndex = 0;
    to.focus();
    event.preventDefault();
  }
}

/** An event that happened in some cells more often than in others; else the first measure that differs. */
function telling(layers) {
  const differs = (layer, part) => {
    const cells = layer.cells.filter((_, index) => index % 4 === part && layer.cells[index - part] > 0);
    return Math.max(...cells) > Math.min(...cells);
  };
  const events = layers.filter((layer) => layer.event && differs(layer, PARTS.mean));
  const unwanted = events.find((layer) => layer.name !== "goal");
  const measures = layers.filter((layer) => !layer.event && differs(layer, PARTS.least));
  const distance = measures.find((layer) => layer.name === "distance");
  return unwanted || events[0] || distance || measures[0] || layers[0];
}

/** Of a part of a range, where it begins: so much fits below a cell. */
function begin(label) {
  return label.split(" to ")[0];
}

function heat(maps) {
  if (maps.length === 0 || maps[0].layers.length === 0) {
    return null;
  }
  const map = new Heat(maps);
  return section("heat", "Which values go wrong", map.controls, element("div", { class: "panel" }, map.grid, map.legend, map.readout));
}
