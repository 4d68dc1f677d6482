// Begins.

const stories = new Stories(JSON.parse(document.getElementById("data").textContent).stories);
listenToKeys(stories);
