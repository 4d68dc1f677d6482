'use strict';
// A click on a part of a picture says where it stands in the models.
(() => {
  const host = acquireVsCodeApi();
  document.addEventListener('click', (event) => {
    const part = event.target.closest('svg [data-place]');
    if (part) {
      event.preventDefault();
      host.postMessage({ place: part.dataset.place });
    }
  });
})();
