// In a worker, behind the core: one question after the other.

const module = compile(packed);

/** What lies on the desk. */
let checked = null;
let desk = null;
let turn = Promise.resolve();

/** Begins a core with what lies on the desk. That there is none is told to who asks. */
function take() {
    desk = module.then(begin).then((fresh) => {
        if (checked) {
            fresh.check(...checked);
        }
        return fresh;
    });
    desk.catch(() => {});
}

async function answerTo({ id, ask, args }) {
    try {
        const answer = (await desk)[ask](...args);
        if (ask === 'check') {
            checked = args;
        }
        self.postMessage({ id, answer });
    } catch (problem) {
        self.postMessage({ id, problem: String((problem && problem.message) || problem) });
        // Where Java knows nothing of an error, as of a stack that is full, the core may have stopped in the middle of something.
        if (!(problem instanceof Thrown)) {
            take();
        }
    }
}

self.onmessage = (event) => {
    turn = turn.then(() => answerTo(event.data));
};
take();
