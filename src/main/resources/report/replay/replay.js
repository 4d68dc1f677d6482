// Begins.

const stage = new Stage(new Recording(JSON.parse(document.getElementById("data").textContent)));
document.getElementById("scene").append(stage.floor.svg);
document.getElementById("player").append(...stage.player.elements());
document.getElementById("robots").append(...stage.cards.cards.map((each) => each.card));
document.getElementById("events").append(element("h2", {}, "What happened"), stage.happenings.list);
// A button that was clicked keeps the focus, and the keys work all the same.
document.addEventListener("keydown", (event) => stage.key(event));
// index.html#7.5 opens at that second.
stage.player.go(1000 * Number(location.hash.slice(1)) || 0);
