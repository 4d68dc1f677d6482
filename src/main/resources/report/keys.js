// What keys do, and the list of them.

const KEYS = [
  ["\u2190 \u2192", "one step back, one step on"],
  ["Shift \u2190 \u2192", "to the change before, to the next change: of the chosen row, or of any"],
  ["Home End", "to the first step, to the last"],
  ["Space", "play, pause"],
  ["\u2191 \u2193", "choose a row"],
  ["Alt \u2191 \u2193", "move the chosen row up or down"],
  ["z Z", "fold the part of the chosen row, or unfold it; all groups"],
  ["Escape", "choose none"],
  ["+ \u2212 0", "larger, smaller, the whole run"],
  ["/", "find a value: fwd, or cmd = fwd"],
  ["n N", "to the next place found, to the one before"],
  ["f F", "to the next flaw, to the one before"],
  ["[ ]", "the run before, the next run"],
  ["?", "these keys"],
];

/** By the name of the key; the story is the one that is shown. */
const ACTIONS = {
  ArrowLeft: (story, shift) => (shift ? story.toChange(-1) : story.go(story.cursor - 1)),
  ArrowRight: (story, shift) => (shift ? story.toChange(1) : story.go(story.cursor + 1)),
  "Alt ArrowUp": (story) => story.move(-1),
  "Alt ArrowDown": (story) => story.move(1),
  ArrowUp: (story) => story.selectNext(-1),
  ArrowDown: (story) => story.selectNext(1),
  " ": (story) => story.play.toggle(),
  z: (story) => story.fold(),
  Z: (story) => story.timeline.groups.foldAll(),
  Home: (story) => story.go(0),
  End: (story) => story.go(story.length - 1),
  Escape: (story) => story.select(null),
  "+": (story) => story.timeline.zoom(1.6),
  "=": (story) => story.timeline.zoom(1.6),
  "-": (story) => story.timeline.zoom(1 / 1.6),
  0: (story) => story.timeline.showAll(),
  "/": (story) => story.search.begin(),
  n: (story) => story.search.next(1),
  N: (story) => story.search.next(-1),
  f: (story) => story.toFlaw(1),
  F: (story) => story.toFlaw(-1),
};

/** They move the page or a list unless the timeline has the focus. */
const ONLY_IN_TIMELINE = new Set(["ArrowUp", "ArrowDown", "Alt ArrowUp", "Alt ArrowDown", "Home", "End"]);

function listenToKeys(stories) {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || isForItself(event) || document.getElementById("help").open) {
      return;
    }
    if (handle(event, stories)) {
      event.preventDefault();
    }
  });
}

/** What is written into a field or chosen from a list is nobody else's, and space presses the button that it is at. */
function isForItself(event) {
  return event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement || (event.key === " " && event.target.closest("button") !== null);
}

/** Whether the key means something here. */
function handle(event, stories) {
  const key = event.altKey ? "Alt " + event.key : event.key;
  if (key === "?") {
    showHelp();
  } else if (key === "[" || key === "]") {
    stories.showNext(key === "]" ? 1 : -1);
  } else {
    const story = stories.current;
    const inTimeline = event.target.closest(".timeline") !== null;
    if (!Object.hasOwn(ACTIONS, key) || !story || story.length === 0 || (ONLY_IN_TIMELINE.has(key) && !inTimeline)) {
      return false;
    }
    ACTIONS[key](story, event.shiftKey);
  }
  return true;
}

function showHelp() {
  const help = document.getElementById("help");
  const rows = KEYS.map(([keys, meaning]) =>
    element("tr", {}, element("th", { scope: "row" }, ...keys.split(" ").map((key) => element("kbd", {}, key))), element("td", {}, meaning)),
  );
  help.replaceChildren(
    element("h2", {}, "Keys"),
    element("table", {}, ...rows),
    element("p", {}, "A click sets the cursor; Shift and the wheel move, Ctrl and the wheel zoom."),
    button("Close", "Close", () => help.close()),
  );
  help.showModal();
}
