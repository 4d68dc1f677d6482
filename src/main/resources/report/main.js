// Begins.

const stories = new Stories(JSON.parse(document.getElementById("data").textContent).stories);
stories.address = new Address(stories);
stories.address.open();
listenToKeys(stories);
listenToPrinters(stories);
