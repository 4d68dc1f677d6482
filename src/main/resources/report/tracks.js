// Tracks: columns of values as run lengths. The data has pairs of value and length; here they are
// two typed arrays, so that a step is found by halving.

const NOTHING = -1;
const MOST_COLOURS = 8;

class Track {
  constructor(data) {
    this.group = data.group;
    this.name = data.name;
    this.kind = data.kind;
    this.before = data.before;
    this.values = data.values;
    this.elements = data.elements || [];
    this.count = data.runs.length / 2;
    this.codes = new Int32Array(this.count);
    this.starts = new Int32Array(this.count + 1);
    for (let run = 0; run < this.count; run++) {
      this.codes[run] = data.runs[2 * run];
      this.starts[run + 1] = this.starts[run] + data.runs[2 * run + 1];
    }
    const numbers = this.values.map((text) => (text.trim() === "" ? NaN : Number(text)));
    this.numbers = this.values.length > 2 && numbers.every(Number.isFinite) ? numbers : null;
    this.least = numbers.reduce((least, number) => Math.min(least, number), Infinity);
    this.greatest = numbers.reduce((greatest, number) => Math.max(greatest, number), -Infinity);
  }

  /** The run that a step lies in. */
  runAt(step) {
    let low = 0;
    let high = this.count - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.starts[middle] <= step) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  codeAt(step) {
    return this.count === 0 ? NOTHING : this.codes[this.runAt(step)];
  }

  /** The text at a step; null where there is nothing. Before the first step it is what it began as. */
  textAt(step) {
    if (step < 0) {
      return this.before === "" ? null : this.before;
    }
    const code = this.codeAt(step);
    return code === NOTHING ? null : this.values[code];
  }

  elementsAt(step) {
    const code = this.codeAt(step);
    return code === NOTHING ? [] : this.elements[code] || [];
  }

  /** The first step of the current value. */
  sinceWhen(step) {
    return this.starts[this.runAt(step)];
  }

  /** The next step at which it changes, or -1. */
  nextChange(step) {
    const run = this.runAt(step) + 1;
    return run < this.count ? this.starts[run] : -1;
  }

  /** The last step before this one at which it changed, or -1. */
  previousChange(step) {
    const run = this.runAt(step);
    const start = this.starts[run] < step ? this.starts[run] : run > 0 ? this.starts[run - 1] : 0;
    return start < step ? start : -1;
  }
}

/**
 * Colours of values. What is the same looks the same in all tracks, as far as that goes: values of
 * one track that are different have to look different first.
 */
class Colours {
  constructor() {
    this.preferred = new Map();
    this.byTrack = new Map();
  }

  /** The class of a value of a track. */
  of(track, code) {
    const text = track.values[code];
    if (text === "true" || text === "false") {
      return text === "true" ? "yes" : "no";
    }
    if (track.values.length > MOST_COLOURS) {
      return "many";
    }
    if (!this.byTrack.has(track)) {
      this.byTrack.set(track, this.choose(track.values));
    }
    return "colour" + this.byTrack.get(track)[code];
  }

  choose(values) {
    const taken = new Set();
    const chosen = values.map((text) => this.take(this.preferred.get(text), taken));
    return values.map((text, code) => {
      if (chosen[code] !== undefined) {
        return chosen[code];
      }
      const next = this.preferred.size % MOST_COLOURS;
      const free = [...Array(MOST_COLOURS).keys()].map((each) => (each + next) % MOST_COLOURS).find((each) => !taken.has(each));
      if (!this.preferred.has(text)) {
        this.preferred.set(text, free);
      }
      return this.take(free, taken);
    });
  }

  /** The colour, unless another value of the track has it. */
  take(colour, taken) {
    if (colour === undefined || taken.has(colour)) {
      return undefined;
    }
    taken.add(colour);
    return colour;
  }
}
