// What goes on inside of the robots: the run of each program, at the moment that the floor shows.

/** A run that goes as the floor goes. */
class InnerStory extends Story {
  /** Of so many slices each piece shows enough: most values last, and numbers of sensors are curves. */
  get onPaper() {
    return { fewest: 75, most: 75 };
  }

  /** Who plays and steps is the floor's player. */
  tools() {
    return [this.zooms(), this.search.element];
  }
}

class Inside {
  /** @param stories one for each robot that has something to show, @param go moves the floor to a moment */
  constructor(stories, go) {
    this.data = stories;
    this.index = 0;
    this.go = go;
    this.changed = () => {};
    this.colours = new Colours();
    this.arrangement = new Arrangement();
    this.arrangement.changed = () => this.changed();
    this.time = 0;
    this.place = element("article", { id: "story" });
    this.choices = stories.map((story, index) => button(story.title, "Inside of " + story.title, () => this.choose(index), { "aria-pressed": "false" }));
    const heading = element("h2", {}, "Inside of ", element("span", { class: "choices" }, ...this.choices));
    this.element = element("div", {}, heading, this.place);
  }

  /** Takes its place in the page, which says how large it is. */
  begin() {
    if (this.data.length > 0) {
      this.choose(0);
    }
  }

  choose(index) {
    this.index = index;
    this.current = new InnerStory(this.data[index], this.colours, this.arrangement, () => this.moved());
    this.choices.forEach((choice, each) => choice.setAttribute("aria-pressed", String(each === index)));
    this.current.title = "";
    this.current.cursor = this.step();
    this.current.show(this.place);
    this.changed();
  }

  /** The slice that a moment lies in; the first one until it begins. */
  step() {
    const { times } = this.current;
    return Math.max(0, firstAtLeast(times, this.time + 0.001) - 1);
  }

  show(time) {
    this.time = time;
    if (this.current !== undefined && this.current.length > 0 && this.step() !== this.current.cursor) {
      this.current.go(this.step());
    }
  }

  /** Somebody has gone somewhere in the run: the floor comes along. */
  moved() {
    if (this.current.cursor !== this.step()) {
      this.go(this.current.times[this.current.cursor]);
    }
    this.changed();
  }

  /** Whether a key means something here. */
  key(event) {
    const keys = {
      "/": () => this.current.search.begin(),
      n: () => this.current.search.next(1),
      N: () => this.current.search.next(-1),
      z: () => this.current.fold(),
      Z: () => this.current.timeline.groups.foldAll(),
      Escape: () => this.current.select(null),
      ...(event.target.closest(".timeline") === null ? {} : { ArrowUp: () => this.upOrDown(event, -1), ArrowDown: () => this.upOrDown(event, 1) }),
    };
    if (this.current === undefined || !Object.hasOwn(keys, event.key) || event.ctrlKey || event.metaKey) {
      return false;
    }
    keys[event.key]();
    return true;
  }

  upOrDown(event, direction) {
    if (event.altKey) {
      this.current.move(direction);
    } else {
      this.current.selectNext(direction);
    }
  }
}

/** The address of a floor: its second, then what is to be seen inside of which robot. */
class FloorAddress extends Address {
  constructor(inside, player) {
    super(inside);
    this.player = player;
    inside.changed = () => this.change();
  }

  open() {
    super.open();
    const second = parseFloat(location.hash.slice(1));
    if (second >= 0) {
      this.player.go(1000 * second);
    }
  }

  show(index) {
    this.stories.choose(index);
  }

  moment() {
    return String(this.player.time / 1000);
  }

  change() {
    this.follow(this.stories.current);
  }

  of(story) {
    return story === undefined ? this.moment() : super.of(story);
  }
}
