// In a worker, behind the core: one question after the other.

const module = compile(unpack(Uint8Array.fromBase64(packed)));

/** What lies on the desk. */
let checked = null;
let desk = begun();
let turn = Promise.resolve();

/**
 * A core with what lies on the desk. After an error that Java does not know, such as a stack that is full, the one before
 * may have stopped in the middle of something, and gives no answer any more.
 */
async function begun() {
    const fresh = await begin(await module);
    if (checked) {
        fresh.check(...checked);
    }
    return fresh;
}

async function take({ id, ask, args }) {
    try {
        const answer = (await desk)[ask](...args);
        if (ask === 'check') {
            checked = args;
        }
        self.postMessage({ id, answer });
    } catch (problem) {
        self.postMessage({ id, problem: String((problem && problem.message) || problem) });
        if (!(problem instanceof Thrown)) {
            desk = begun();
        }
    }
}

self.onmessage = (event) => {
    turn = turn.then(() => take(event.data));
};
