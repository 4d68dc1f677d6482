// Begins.

const inside = new Inside(JSON.parse(document.getElementById("inner").textContent).stories, (time) => stage.player.go(time));
const stage = new Stage(new Recording(JSON.parse(document.getElementById("data").textContent)), (time) => {
  inside.show(time);
  inside.changed();
});
document.getElementById("scene").append(stage.floor.svg);
document.getElementById("player").append(...stage.player.elements());
if (stage.floor.ghost !== null) {
  document.getElementById("stage").append(stage.floor.ghost.note);
}
document.getElementById("robots").append(...stage.cards.cards.map((each) => each.card));
document.getElementById("events").append(element("h2", {}, "What happened"), stage.happenings.list);
document.getElementById("inside").append(inside.element);
document.getElementById("inside").hidden = inside.data.length === 0;
inside.begin();
listenToPrinters(inside);
// A button that was clicked keeps the focus, and the keys work all the same.
document.addEventListener("keydown", (event) => {
  if (isForThePage(event) && inside.key(event)) {
    event.preventDefault();
  } else {
    stage.key(event);
  }
});
stage.player.go(0);
new FloorAddress(inside, stage.player).open();
