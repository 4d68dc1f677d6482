package arcomat.sim.script;

import arcomat.sim.device.Stimulus;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Reads what a sensor is exposed to: a number, a name for one, or a raw number. */
final class Values {
    /** Colours as lejos.robotics.Color counts them. */
    private static final Map<String, Stimulus> NAMES =
            Map.ofEntries(
                    Map.entry("released", Stimulus.pressed(false)),
                    Map.entry("pressed", Stimulus.pressed(true)),
                    Map.entry("red", Stimulus.color(0)),
                    Map.entry("green", Stimulus.color(1)),
                    Map.entry("blue", Stimulus.color(2)),
                    Map.entry("yellow", Stimulus.color(3)),
                    Map.entry("white", Stimulus.color(6)),
                    Map.entry("black", Stimulus.color(7)));

    private static final int RAW_LIMIT = 1023;

    private Values() {}

    /** What may stand in the place of a number. */
    static List<String> words() {
        return Stream.concat(NAMES.keySet().stream().sorted(), Stream.of("raw", "unplugged"))
                .toList();
    }

    static Stimulus parse(Line line) throws BrokenLine {
        Word word = line.next("a value: a number, pressed, released, a colour, raw or unplugged");
        if (word.text().equals("unplugged")) {
            return Stimulus.NONE;
        }
        if (word.text().equals("raw")) {
            return Stimulus.raw(line.number("a raw value", 0, RAW_LIMIT));
        }
        Stimulus named = NAMES.get(word.text());
        return named != null ? named : Stimulus.value(number(word));
    }

    private static int number(Word word) throws BrokenLine {
        try {
            return Integer.parseInt(word.text());
        } catch (NumberFormatException e) {
            List<String> known = NAMES.keySet().stream().sorted().toList();
            throw word.broken(
                    "'%s' is no value: write a whole number, raw and a number, unplugged, or one of %s"
                            .formatted(word.text(), String.join(", ", known)));
        }
    }
}
