// Pictures that follow the run: what the tracks show at a step is marked in them.

class Pictures {
  constructor(story) {
    this.story = story;
    const templates = document.querySelectorAll("template.picture");
    this.all = story.drawings.map((drawing) => {
      const svg = templates[drawing.picture].content.firstElementChild.cloneNode(true);
      const tracks = story.tracks.filter((track) => drawing.tracks.includes(track.name));
      const figure = element("figure", {}, element("figcaption", {}, drawing.title), element("div", { class: "drawing" }, svg));
      return { figure, svg, tracks };
    });
    const figures = this.all.map((each) => each.figure);
    this.element = element("section", { class: "pictures", "aria-label": "Automata", hidden: figures.length === 0 }, ...figures);
  }

  show(step) {
    for (const { svg, tracks } of this.all) {
      for (const marked of svg.querySelectorAll(".active, .left")) {
        marked.classList.remove("active", "left");
      }
      for (const track of tracks) {
        if (step > 0 && track.kind === "state") {
          mark(svg, track.elementsAt(step - 1), "left");
        }
        mark(svg, track.elementsAt(step), "active");
      }
    }
  }
}

/** Elements are named by their kind and which one of it: "state 2"; some stand for several. */
function mark(svg, elements, style) {
  for (const name of elements) {
    const [kind, which] = name.split(" ");
    for (const found of svg.querySelectorAll(`[data-${kind}~="${CSS.escape(which)}"]`)) {
      found.classList.add(style);
    }
    if (kind === "transition") {
      mark(svg, ["arrow " + which], style);
    }
  }
}
