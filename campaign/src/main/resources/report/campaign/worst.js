// The course of a search for the worst case: a dot is the worst run of a generation, the line the worst so far.

const COURSE = { left: 8, right: 99, top: 8, bottom: 92 };

class Course {
  constructor(worst) {
    this.worst = worst;
    this.known = worst.course.map((step) => step.worst).filter((value) => value !== undefined);
    this.low = Math.min(...this.known);
    this.high = Math.max(...this.known);
  }

  x(index) {
    return COURSE.left + ((COURSE.right - COURSE.left) * (index + 0.5)) / this.worst.course.length;
  }

  y(value) {
    const part = this.high === this.low ? 0.5 : (value - this.low) / (this.high - this.low);
    return COURSE.bottom - (COURSE.bottom - COURSE.top) * part;
  }

  isWorse(value, than) {
    return than === null || (this.worst.which === "smallest" ? value < than : value > than);
  }

  /** What had been found after each step; null before there is something. */
  soFar() {
    let found = null;
    return this.worst.course.map((step) => {
      if (step.worst !== undefined && this.isWorse(step.worst, found)) {
        found = step.worst;
      }
      return found;
    });
  }
}

function courseLine(course) {
  const lines = [];
  course.soFar().forEach((value, index, all) => {
    if (value === null) {
      return;
    }
    const end = index + 1 < all.length ? course.x(index + 1) : COURSE.right;
    lines.push(shape("line", { class: "so-far", x1: course.x(index) + "%", x2: end + "%", y1: course.y(value) + "%", y2: course.y(value) + "%" }));
    if (index > 0 && all[index - 1] !== null && all[index - 1] !== value) {
      lines.push(shape("line", { class: "so-far", x1: course.x(index) + "%", x2: course.x(index) + "%", y1: course.y(all[index - 1]) + "%", y2: course.y(value) + "%" }));
    }
  });
  return lines;
}

function courseDots(course) {
  let first = 1;
  return course.worst.course.map((step, index) => {
    const last = first + step.generations - 1;
    const name = first === last ? `generation ${first}` : `generations ${first} to ${last}`;
    first = last + 1;
    return step.worst === undefined
      ? null
      : shape("circle", { class: "generation", cx: course.x(index) + "%", cy: course.y(step.worst) + "%", r: 4 }, shape("title", {}, `${name}: ${number(step.worst)}`));
  });
}

function courseLabels(course) {
  const values = course.high === course.low ? [course.low] : [course.low, course.high];
  return values.map((value) => shape("text", { x: COURSE.left - 1 + "%", y: course.y(value) + "%", "text-anchor": "end", "dominant-baseline": "middle" }, number(value)));
}

function worst(answer) {
  const all = answer.worst;
  if (all === undefined) {
    return null;
  }
  const said = element("p", { class: "said" }, worstWords(all));
  const course = new Course(all);
  if (course.known.length === 0) {
    return section("worst", "The worst case", said);
  }
  const generations = all.course.reduce((sum, step) => sum + step.generations, 0);
  const told = `from generation 1 to ${count(generations)}, left to right`;
  const picture = shape("svg", { class: "course", role: "img", "aria-label": `${worstWords(all)} ${told}` }, ...courseLine(course), ...courseDots(course).filter((dot) => dot !== null), ...courseLabels(course));
  const figure = element("figure", {}, element("figcaption", {}, element("strong", {}, all.measure), element("span", {}, `worst of each generation, ${told}; the line is the worst so far`)), picture);
  const explained = element("p", { class: "explained" }, "A generation tries values near those that were worst. It finds what is near; that there is nothing worse, it does not say.");
  return section("worst", "The worst case", said, element("div", { class: "figures-grid wide" }, figure), explained, element("ol", { class: "runs" }, shown(all.run, `the worst run, seed ${all.run.seed}`)));
}

function worstWords(all) {
  const tried = `a search of ${runs(all.runs)}${all.unknown > 0 ? `, ${count(all.unknown)} of them without such a number,` : ""}`;
  const begun = all.searches > 1 ? ` It settled and began elsewhere ${count(all.searches - 1)} ${all.searches === 2 ? "time" : "times"}.` : "";
  return all.run === undefined
    ? `The ${all.which} ${all.measure}: none of the ${runs(all.runs)} of the search has such a number.`
    : `The ${all.which} ${all.measure} that ${tried} has found is ${number(all.value)}.${begun}`;
}
