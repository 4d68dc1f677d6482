'use strict';
// Marks the part of the picture that the cursor is in: the one that begins nearest above it.
(() => {
  function lineOf(part, file) {
    const [, path, line] = /^(.*):(\d+)$/.exec(part.dataset.place) ?? [];
    return path !== undefined && (path === file || file.endsWith('/' + path)) ? Number(line) : 0;
  }

  window.addEventListener('message', ({ data }) => {
    const parts = [...document.querySelectorAll('[data-place]')];
    const lines = parts.map((part) => lineOf(part, data.file));
    const here = Math.max(...lines.filter((line) => line <= data.line), 0);
    parts.forEach((part, i) => part.classList.toggle('here', here > 0 && lines[i] === here));
  });
})();
