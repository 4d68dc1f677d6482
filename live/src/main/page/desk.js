// The core in a worker: what is asked comes back as a promise. A worker that is stopped is replaced by a new one.

const LAYOUT = 'layout';

/** Answers in the order of the questions. */
export class Desk {
    constructor() {
        this.waiting = new Map();
        this.next = 0;
        this.start();
    }

    start() {
        this.worker = takeCore();
        this.worker.onmessage = (event) => this.take(event.data);
    }

    take({ id, answer, problem }) {
        const { resolve, reject } = this.waiting.get(id);
        this.waiting.delete(id);
        if (problem === undefined) {
            resolve(answer);
        } else {
            reject(new Error(problem));
        }
    }

    ask(ask, ...args) {
        return new Promise((resolve, reject) => {
            const id = this.next++;
            this.waiting.set(id, { resolve, reject });
            this.worker.postMessage({ id, ask, args });
        });
    }

    /** Gives up all that is being asked. */
    stop() {
        this.worker.terminate();
        const given = [...this.waiting.values()];
        this.waiting.clear();
        this.start();
        given.forEach(({ reject }) => reject(new Error('stopped')));
    }
}

/** Finds places for what is to be drawn; begins where the first picture is asked for. */
export class Layout {
    place(graph) {
        this.last = (this.last || Promise.resolve()).catch(() => {}).then(() => this.now(graph));
        return this.last;
    }

    now(graph) {
        this.worker = this.worker || begin([LAYOUT]);
        return new Promise((resolve, reject) => {
            this.worker.onmessage = (event) => resolve(event.data);
            this.worker.onerror = (event) => reject(new Error(event.message));
            this.worker.postMessage({ graph, options: {} });
        });
    }
}
