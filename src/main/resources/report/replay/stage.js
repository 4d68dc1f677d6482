// The floor, its robots, what happened, and who plays it: all of them at one moment.

class Stage {
  constructor(recording) {
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
    const where = event.target;
    const isOurs = where.id !== "speed" && !(event.key === " " && where.closest("button, summary, a"));
    if (isOurs && Object.hasOwn(keys, event.key) && !event.ctrlKey && !event.altKey && !event.metaKey) {
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
