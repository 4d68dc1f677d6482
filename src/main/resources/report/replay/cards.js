// What is known of each robot at a moment.

const UNITS = { ultrasonic: " cm", chute: " cm", light: " %", lamp: " %" };
const NOTHING_SEEN = 255;

class Cards {
  constructor(recording, follow) {
    this.recording = recording;
    this.cards = recording.world.robots.map((robot, number) => this.card(robot, number, follow));
  }

  card(robot, number, follow) {
    const isUsed = this.recording.frames.some((frame) => Recording.parts(frame.robots[number]).display !== "");
    const display = element("p", { class: "display", hidden: !isUsed });
    const facts = new Map();
    const list = element("dl", {});
    const names = [
      ...(robot.moves ? ["wheels", "cup"] : ["work"]),
      ...robot.sensors.map((sensor) => sensor.type + " " + sensor.socket),
    ];
    for (const name of names) {
      const value = element("dd", {});
      facts.set(name, value);
      list.append(element("dt", {}, name), value);
    }
    const mark = robot.moves ? button("Follow", "Follow " + robot.name, () => follow(number), { "aria-pressed": "false" }) : null;
    const heading = element("h2", {}, element("span", {}, robot.name), mark);
    const card = element("article", { class: "card" }, heading, element("p", { class: "kind" }, robot.program), display, list);
    const idle = element("ul", {});
    if (this.recording.idling?.parts.some((each) => each.robot === robot.name)) {
      card.append(element("details", { class: "idle" }, element("summary", {}, "Why not"), idle));
    }
    return { card, display, facts, mark, robot, idle };
  }

  follow(number) {
    this.cards.forEach(({ card, mark }, index) => {
      card.classList.toggle("followed", index === number);
      if (mark !== null) {
        mark.setAttribute("aria-pressed", String(index === number));
      }
    });
  }

  show(time) {
    this.cards.forEach(({ display, facts, robot, idle }, number) => {
      const now = this.recording.robot(number, time);
      display.textContent = now.display;
      idle.replaceChildren(
        ...this.recording.idle(robot.name, time).map(({ part, words }) => element("li", {}, (part === "" ? "" : part + ": ") + words)),
      );
      if (robot.moves) {
        facts.get("wheels").textContent = `${now.left} and ${now.right} mm/s`;
        facts.get("cup").textContent = now.cup;
      } else {
        facts.get("work").textContent = now.isBrewing ? "brewing" : now.stock > 0 ? `${now.stock} cups left` : "idle";
      }
      robot.sensors.forEach((sensor, index) => {
        facts.get(sensor.type + " " + sensor.socket).textContent = reading(sensor.type, now.readings[index]);
      });
    });
  }
}

function reading(type, value) {
  if (UNITS[type] === undefined) {
    return value === 1 ? "pressed" : "released";
  }
  return UNITS[type] === " cm" && value >= NOTHING_SEEN ? "nothing" : value + UNITS[type];
}
