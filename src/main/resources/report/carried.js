// What the ports of an architecture carry: at the cursor, each wire with a message is lit and says which one.

const LONGEST_ON_A_WIRE = 14;

class Carried {
  /** @param rows the tracks of ports, by the paths of the ports */
  constructor(svg, carried, tracks) {
    const byName = new Map(tracks.map((track) => [track.name, track]));
    this.wires = [...svg.querySelectorAll("[data-connector]")]
      .map((wire) => ({ wire, track: byName.get(carried[senderOf(wire)]) }))
      .filter(({ track }) => track !== undefined);
    this.signs = this.senders().flatMap((port) => {
      const track = byName.get(carried[port]);
      const place = svg.querySelector(`[data-port="${CSS.escape(port)}"]`);
      return track === undefined || place === null ? [] : [this.sign(port, place, track)];
    });
    svg.append(...this.signs.map((sign) => sign.text));
  }

  /** One sign for each port that a wire begins at. */
  senders() {
    return [...new Set(this.wires.map(({ wire }) => senderOf(wire)))];
  }

  /** Beside the port, above its wire; what is longer than there is room tells the rest when asked. */
  sign(port, place, track) {
    const { x, y, width } = boxOf(place.querySelector("rect"));
    const whose = { "data-beside": port, "data-in": Wires.owner(Wires.owner(port)) }; // for who folds
    const title = shape("title");
    const line = shape("tspan");
    return { track, line, title, text: shape("text", { class: "carried", ...whose, x: x + width + 4, y: y - 1 }, title, line) };
  }

  show(step) {
    for (const { wire, track } of this.wires) {
      wire.classList.toggle("live", track.codeAt(step) !== NOTHING);
    }
    for (const { track, line, title } of this.signs) {
      const text = track.textAt(step) || "";
      line.textContent = text.length > LONGEST_ON_A_WIRE ? text.slice(0, LONGEST_ON_A_WIRE - 1) + "\u2026" : text;
      title.textContent = text === "" ? "" : `${track.name} = ${text}`;
    }
  }
}

/** "a.b -> c.d" is called by its path: the port that it comes from stands in front. */
function senderOf(wire) {
  return wire.dataset.connector.split(" -> ")[0];
}

/** A picture that is not in the page yet has no places but what is written. */
function boxOf(rectangle) {
  const number = (name) => Number(rectangle.getAttribute(name));
  return { x: number("x"), y: number("y"), width: number("width") };
}
