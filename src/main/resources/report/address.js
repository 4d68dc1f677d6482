// The address says what is to be seen, for others and for later: #17 is the slice, #17/cmd the chosen row as well, and
// #17/cmd/p.DoorTest#waits, or only #17/cmd/waits, the run where there are several.

/** Browsers forbid to change it all the time. */
const PAUSE = 300;

class Address {
  constructor(stories) {
    this.stories = stories;
    this.wish = 0;
    this.open();
    addEventListener("hashchange", () => this.open());
  }

  /** Goes where it says; what it does not say, or what there is none of, stays as it is. */
  open() {
    const [step, row, run] = location.hash.slice(1).split("/").map(decoded);
    const stories = this.stories;
    const index = stories.data.findIndex((story) => story.title === run || story.title.endsWith("#" + run));
    if (index >= 0 && index !== stories.index) {
      stories.show(index);
    }
    const story = stories.current;
    if (!story || story.length === 0) {
      return;
    }
    if (row) {
      story.select(story.timeline.find(row));
    }
    if (/^\d+$/.test(step)) {
      story.go(Number(step));
    }
  }

  /** Follows what is shown. */
  follow(story) {
    clearTimeout(this.wish);
    this.wish = setTimeout(() => history.replaceState(null, "", "#" + this.of(story)), PAUSE);
  }

  of(story) {
    const run = this.stories.data.length > 1 ? story.title : "";
    const parts = [String(story.cursor), story.selected === null ? "" : story.selected.name, run];
    return parts.map(encodeURIComponent).join("/").replace(/\/+$/, "");
  }
}

function decoded(part) {
  try {
    return decodeURIComponent(part);
  } catch {
    return "";
  }
}
