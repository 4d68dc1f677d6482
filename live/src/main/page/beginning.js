// Comes right behind the code of the core, and starts it: in its worker it gets ready while the rest of the page is being read.

function codeOf(name) {
    return document.getElementById('code-' + name).textContent;
}

/** A worker with such code. */
function begin(parts) {
    const url = URL.createObjectURL(new Blob(parts.map(codeOf), { type: 'text/javascript' }));
    const worker = new Worker(url);
    worker.addEventListener('message', () => URL.revokeObjectURL(url), { once: true });
    return worker;
}

function beginCore() {
    return begin(['core', 'worker']);
}

/** The worker that was started at once, for who comes first. */
let early = beginCore();

/** A worker that nobody else asks. */
function takeCore() {
    const worker = early || beginCore();
    early = null;
    return worker;
}
