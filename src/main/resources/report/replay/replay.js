// Begins.

const recording = new Recording(JSON.parse(document.getElementById("data").textContent));
const floor = new Floor(recording);
const player = new Player(recording, (time) => {
  floor.show(time);
  cards.show(time);
  happenings.show(time);
  inside.show(time);
});
const happenings = new Happenings(recording.events, (time) => player.go(time));
const cards = new Cards(recording, (number) => {
  const followed = number === floor.followed ? -1 : number;
  floor.follow(followed);
  cards.follow(followed);
  player.go(player.time);
});
const inside = new Inside(JSON.parse(document.getElementById("inner").textContent).stories, (time) => player.go(time));
document.getElementById("scene").append(floor.svg);
document.getElementById("player").append(...player.elements());
if (floor.ghost !== null) {
  document.getElementById("stage").append(floor.ghost.note);
}
document.getElementById("robots").append(...cards.cards.map((each) => each.card));
document.getElementById("events").append(element("h2", {}, "What happened"), happenings.list);
document.getElementById("inside").append(inside.element);
document.getElementById("inside").hidden = inside.stories.length === 0;
inside.begin();
listenToPrinters(inside);

const KEYS = {
  " ": () => player.toggle(),
  ArrowLeft: (shift) => player.go(shift ? happenings.neighbour(player.time, -1) : player.time - recording.period),
  ArrowRight: (shift) => player.go(shift ? happenings.neighbour(player.time, 1) : player.time + recording.period),
  Home: () => player.go(0),
  End: () => player.go(recording.length),
  "+": () => player.faster(1),
  "-": () => player.faster(-1),
};

/** A button that was clicked keeps the focus: only what it does with a key itself is left to it, and the choice of speeds. */
function isOurs(event) {
  const where = event.target;
  const isWritten = where instanceof HTMLInputElement && where.type !== "range";
  return where.id !== "speed" && !isWritten && !(event.key === " " && where.closest("button, summary, a"));
}
document.addEventListener("keydown", (event) => {
  if (isOurs(event) && inside.key(event)) {
    event.preventDefault();
  } else if (isOurs(event) && Object.hasOwn(KEYS, event.key) && !event.ctrlKey && !event.altKey && !event.metaKey) {
    KEYS[event.key](event.shiftKey);
    event.preventDefault();
  }
});
// index.html#7.5 opens at that second.
player.go(1000 * Number(location.hash.slice(1)) || 0);
