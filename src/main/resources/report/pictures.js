// Pictures that follow the run: what the tracks show at a step is marked in them.

class Pictures {
  constructor(story) {
    this.story = story;
    const templates = document.querySelectorAll("template.picture");
    this.all = story.drawings.map((drawing) => {
      const svg = templates[drawing.picture].content.firstElementChild.cloneNode(true);
      const tracks = story.tracks.filter((track) => drawing.tracks.includes(track.name));
      const viewer = new PictureViewer(svg, drawing.title);
      const figure = element("figure", {}, element("figcaption", {}, drawing.title), viewer.element);
      figure.style.flexBasis = svg.getAttribute("width") + "px";
      const carried = drawing.carried === undefined ? null : new Carried(svg, drawing.carried, story.tracks);
      return { figure, svg, tracks, carried };
    });
    const figures = this.all.map((each) => each.figure);
    this.element = element("section", { class: "pictures", "aria-label": "Architecture and automata", hidden: figures.length === 0 }, ...figures);
  }

  show(step) {
    for (const { svg, tracks, carried } of this.all) {
      if (carried !== null) {
        carried.show(step);
      }
      for (const marked of svg.querySelectorAll(".active, .left, .stuck")) {
        marked.classList.remove("active", "left", "stuck");
      }
      for (const track of tracks) {
        const now = track.elementsAt(step);
        const before = step > 0 ? track.elementsAt(step - 1).filter(isState) : [];
        mark(svg, before, track.kind === "path" && !now.some(isState) ? "stuck" : "left");
        mark(svg, now, "active");
      }
    }
  }
}

function isState(name) {
  return name.startsWith("state ");
}

/**
 * Elements are named by their kind and which one of it: "state 2". Transitions between the same
 * states share an arrow, "2 5", and those into one state that say the same a label; the arrow of a beginning is "initial 0".
 */
function mark(svg, elements, style) {
  for (const name of elements) {
    const [kind, which] = name.split(" ");
    const selectors = [`[data-${kind}~="${CSS.escape(which)}"]`];
    if (kind === "transition") {
      selectors.push(`[data-arrow~="${CSS.escape(which)}"]:not([data-arrow^="initial"])`);
    } else if (kind === "initial") {
      selectors.push(`[data-arrow="${CSS.escape(name)}"]`);
    }
    for (const found of svg.querySelectorAll(selectors.join(","))) {
      found.classList.add(style);
    }
  }
}
