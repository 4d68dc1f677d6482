// Begins.

const data = JSON.parse(document.getElementById("data").textContent);
const answer = data.answer;
const parts = [asked(answer), verdicts(answer), intervals(answer), histograms(answer), heat(data.maps), compared(answer), ...answer.against.map(against), rare(answer), worst(answer), notable(answer), coverage(answer)];
document.querySelector("main").append(...parts.filter((part) => part !== null));
