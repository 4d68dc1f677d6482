// The pictures of a folder, each in a window of its own.

for (const place of document.querySelectorAll("section > svg")) {
  const section = place.parentElement;
  const viewer = new PictureViewer(place, section.querySelector("h2").textContent);
  section.append(viewer.element);
}

/** Names without the text that is looked for are hidden, and so are their pictures. */
document.getElementById("filter").addEventListener("input", (event) => {
  const wanted = event.target.value.trim().toLowerCase();
  for (const name of document.querySelectorAll("nav li")) {
    const hidden = !name.textContent.toLowerCase().includes(wanted);
    name.hidden = hidden;
    document.getElementById(name.dataset.picture).hidden = hidden;
  }
});
