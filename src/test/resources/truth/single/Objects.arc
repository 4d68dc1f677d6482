package single;

import types.Signals.Reading;

/** Objects and texts as messages; attributes are read, objects pass through. */
component Objects(String label = "reading") {
  port
    in Reading reading,
    in String name,
    in char key,
    out Reading good,
    out String text,
    out char last;

  <<completion = "ignore">> automaton {
    variable char kept = 'a';
    state s;

    initial s / {text = label};

    s [reading.valid && reading.value > 2] / {good = reading, text = label + ": " + name};
    s [name == "a" || name != label] / {text = "\"" + name + "\\", last = kept, kept = key};
  }
}
