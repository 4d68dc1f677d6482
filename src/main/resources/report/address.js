// The address says what is to be seen, for others and for later: #17 is the slice, #17/cmd the chosen row as well, and
// #17/cmd/p.DoorTest#waits, or only #17/cmd/waits, the run where there are several. Behind that stand the groups that are
// folded, and orders that somebody gave rows or groups: #17///outputs,part%20a/inputs,j,i;part%20a%2F,part%20a.c,part%20a.b.

/** Browsers forbid to change it all the time. */
const PAUSE = 300;

class Address {
  constructor(stories) {
    this.stories = stories;
    this.wish = 0;
    addEventListener("hashchange", () => this.open());
  }

  /** Goes where it says; what it does not say, or what there is none of, stays as it is. */
  open() {
    const parts = location.hash.slice(1).split("/");
    const [step, row, run] = parts.map(decoded);
    const stories = this.stories;
    const index = stories.data.findIndex((story) => story.title === run || story.title.endsWith("#" + run));
    const isArranged = parts.length > 3 && this.arrange(parts[3], parts[4] || "");
    if (isArranged || (index >= 0 && index !== stories.index)) {
      this.show(index >= 0 ? index : stories.index);
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

  show(index) {
    this.stories.show(index);
  }

  /** What it says first. */
  moment(story) {
    return String(story.cursor);
  }

  /** Folds and orders as it says, as far as there are such groups and rows; false where it says nothing of any. */
  arrange(folded, orders) {
    const tracks = this.stories.data.flatMap((story) => story.tracks);
    const groups = new Set(tracks.map((track) => track.group));
    const names = new Set([...groups, ...tracks.map((track) => track.name)]);
    const lists = orders.split(";").map((order) => order.split(",").map(decoded));
    return this.stories.arrangement.set(
      folded.split(",").map(decoded).filter((name) => groups.has(name)),
      lists
        .filter(([place, ...others]) => groups.has(place.replace(/\/$/, "")) || (place === "" && others.length > 0))
        .map(([place, ...others]) => [place, [...new Set(others.filter((name) => names.has(name)))]]),
    );
  }

  /** Follows what is shown. */
  follow(story) {
    clearTimeout(this.wish);
    this.wish = setTimeout(() => history.replaceState(null, "", "#" + this.of(story)), PAUSE);
  }

  of(story) {
    const { data, index } = this.stories;
    const run = data.length > 1 ? data[index].title : "";
    const { folded, orders } = this.stories.arrangement;
    const parts = [
      ...[this.moment(story), story.selected === null ? "" : story.selected.name, run].map(encodeURIComponent),
      listed([...folded]),
      [...orders].filter(([, names]) => names.length > 0).map(([place, names]) => listed([place, ...names])).join(";"),
    ];
    return parts.join("/").replace(/\/+$/, "");
  }
}

function listed(names) {
  return names.map(encodeURIComponent).join(",");
}

function decoded(part) {
  try {
    return decodeURIComponent(part);
  } catch {
    return "";
  }
}
