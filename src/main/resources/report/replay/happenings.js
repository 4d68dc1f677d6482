// What happened, as a list: a click goes there.

const TELL = {
  COLLISION: (event) => "runs into " + event.whom,
  PUSH: (event) => "pushes " + event.whom,
  CUP_GIVEN: (event) => "gets a cup from " + event.whom,
  CUP_LOST: () => "drops a cup on the floor",
  COFFEE_POURED: (event) => "gets coffee from " + event.whom,
  COFFEE_SPILT: () => "pours coffee on the floor",
  COFFEE_TAKEN: (event) => "brings coffee to " + event.whom,
  SHOWED: (event) => event.text,
  SENT: (event) => "sends " + (event.words ?? message(event.text)),
};
const BAD = new Set(["COLLISION", "CUP_LOST", "COFFEE_SPILT"]);

class Happenings {
  constructor(events, go) {
    this.events = events;
    this.rows = events.map((event) => {
      const row = button("", "Go to " + seconds(event.t), () => go(event.t));
      row.removeAttribute("aria-label");
      row.append(element("span", { class: "when" }, seconds(event.t)), element("span", {}, told(event)));
      return element("li", { class: BAD.has(event.what) ? "bad" : null }, row);
    });
    this.list = element("ol", {}, ...this.rows);
    this.last = -2;
  }

  show(time) {
    let current = -1;
    while (current + 1 < this.events.length && this.events[current + 1].t <= time) {
      current++;
    }
    if (current !== this.last) {
      this.last = current;
      this.rows.forEach((row, index) => {
        row.classList.toggle("past", index < current);
        row.classList.toggle("current", index === current);
      });
    }
  }

  /** What has happened last; nothing before the first event. */
  get words() {
    return this.last < 0 ? "" : told(this.events[this.last]);
  }

  /** The moment of the next event, or of the one before. */
  neighbour(time, direction) {
    const times = this.events.map((event) => event.t);
    const found = direction > 0 ? times.find((t) => t > time) : times.filter((t) => t < time).pop();
    return found === undefined ? time : found;
  }
}

function told(event) {
  return event.who + " " + TELL[event.what](event);
}

function seconds(milliseconds) {
  return (milliseconds / 1000).toFixed(1) + " s";
}

/** A packet as the model library makes them: a channel and a number of four bytes. */
function message(packet) {
  if (packet.length !== 10) {
    return packet;
  }
  const channel = parseInt(packet.slice(0, 2), 16);
  return (parseInt(packet.slice(2), 16) | 0) + " on channel " + channel;
}
