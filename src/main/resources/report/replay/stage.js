// The floor, its robots, what happened, and who plays it: all of them at one moment.

class Stage {
  /** @param beside is shown the same moment */
  constructor(recording, beside = () => {}) {
    this.beside = beside;
    this.recording = recording;
    this.floor = new Floor(recording);
    this.player = new Player(recording, (time) => this.show(time));
    this.happenings = new Happenings(recording.events, (time) => this.player.go(time));
    this.cards = new Cards(recording, (number) => this.follow(number));
  }

  show(time) {
    this.floor.show(time);
    this.cards.show(time);
    this.happenings.show(time);
    this.player.tell(this.happenings.words);
    this.beside(time);
  }

  /** A robot that is followed already is so no more. */
  follow(number) {
    const followed = number === this.floor.followed ? -1 : number;
    this.floor.follow(followed);
    this.cards.follow(followed);
    this.player.go(this.player.time);
  }

  /** Does what a key asks for, unless what has the focus does something with it itself. */
  key(event) {
    const keys = {
      " ": () => this.player.toggle(),
      ArrowLeft: () => this.walk(event.shiftKey, -1),
      ArrowRight: () => this.walk(event.shiftKey, 1),
      Home: () => this.player.go(0),
      End: () => this.player.go(this.recording.length),
      "+": () => this.player.faster(1),
      "-": () => this.player.faster(-1),
    };
    if (isForThePage(event) && Object.hasOwn(keys, event.key) && !event.ctrlKey && !event.altKey && !event.metaKey) {
      keys[event.key]();
      event.preventDefault();
    }
  }

  /** A frame on or back, or to the next event. */
  walk(toEvent, direction) {
    const { player, happenings, recording } = this;
    player.go(toEvent ? happenings.neighbour(player.time, direction) : player.time + direction * recording.period);
  }
}

/** Only what a button does with a key itself is left to it; so are the choice of speeds, and what is written. */
function isForThePage(event) {
  const where = event.target;
  const isWritten = where instanceof HTMLInputElement && where.type !== "range";
  return where.id !== "speed" && !isWritten && !(event.key === " " && where.closest("button, summary, a"));
}
