// In a worker, behind the core: one question after the other.
const desk = new Core();
self.onmessage = (event) => {
    const { id, ask, args } = event.data;
    try {
        self.postMessage({ id, answer: desk[ask](...args) });
    } catch (problem) {
        self.postMessage({ id, problem: String((problem && problem.message) || problem) });
    }
};
