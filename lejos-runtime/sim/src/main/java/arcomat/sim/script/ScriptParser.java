package arcomat.sim.script;

import arcomat.sim.device.Key;
import arcomat.sim.device.SensorName;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Reads scripts, one action per line, {@code #} begins a comment:
 *
 * <pre>
 * 0     S1 255             # a sensor's value in its own unit
 * 1500  S4 pressed         # also released, a colour's name, raw 612, unplugged
 * 3000  button ESCAPE      # pressed for a moment; or for 800 milliseconds: button ESCAPE 800
 * 4000  button ENTER down  # and later: up
 * 10000 end
 * </pre>
 *
 * <p>Times are milliseconds since the brick was switched on and must not go back.
 */
public final class ScriptParser {
    /** Milliseconds that a button is down by itself: a main loop of 100 ms is sure to see it. */
    private static final int TAP = 200;

    private final List<Step> steps = new ArrayList<>();
    private final List<ScriptError> errors = new ArrayList<>();
    private int latest;
    private int latestLine;
    private int endLine;

    private ScriptParser() {}

    public static ParsedScript parse(String text) {
        ScriptParser parser = new ScriptParser();
        int number = 1;
        for (String line : text.split("\\R", -1)) {
            parser.read(line, number++);
        }
        return parser.result();
    }

    private ParsedScript result() {
        if (!errors.isEmpty()) {
            return new ParsedScript(Optional.empty(), errors);
        }
        steps.sort(Comparator.comparingLong(Step::time)); // releases of buttons go to their places
        return new ParsedScript(Optional.of(new Script(steps)), errors);
    }

    private void read(String text, int number) {
        List<Word> words = Word.split(text, number);
        if (words.isEmpty()) {
            return;
        }
        try {
            if (endLine > 0) {
                throw words.get(0).broken("nothing happens after the end in line " + endLine);
            }
            read(new Line(words), words.get(0));
        } catch (BrokenLine e) {
            errors.add(e.error());
        }
    }

    private void read(Line line, Word first) throws BrokenLine {
        int time = line.number("a time in milliseconds", 0, Integer.MAX_VALUE);
        if (time < latest) {
            throw first.broken(
                    "time goes back: %d comes after %d in line %d"
                            .formatted(time, latest, latestLine));
        }
        latest = time;
        latestLine = first.line();
        Word port = line.next("a port S1 to S4, button or end");
        List<Step> read =
                switch (port.text()) {
                    case "end" -> end(time, port);
                    case "button" -> button(time, line);
                    default -> List.of(new Step(time, sensor(port, line)));
                };
        line.end();
        steps.addAll(read);
    }

    private List<Step> end(int time, Word word) {
        endLine = word.line();
        return List.of(new Step(time, new Action.End()));
    }

    private static Action sensor(Word port, Line line) throws BrokenLine {
        for (SensorName socket : SensorName.values()) {
            if (socket.name().equals(port.text())) {
                return new Action.Expose(socket, Values.parse(line));
            }
        }
        throw port.broken(
                "'%s' is not a port: write S1, S2, S3, S4, button or end".formatted(port.text()));
    }

    private static List<Step> button(int time, Line line) throws BrokenLine {
        Key key = line.constant(Key.class, "a button");
        Step press = new Step(time, new Action.Press(key));
        if (!line.hasNext()) {
            return List.of(press, new Step(time + (long) TAP, new Action.Release(key)));
        }
        Word manner = line.next("down, up or a number of milliseconds");
        return switch (manner.text()) {
            case "down" -> List.of(press);
            case "up" -> List.of(new Step(time, new Action.Release(key)));
            default -> List.of(press, new Step(time + duration(manner), new Action.Release(key)));
        };
    }

    private static long duration(Word word) throws BrokenLine {
        return new Line(List.of(word)).number("down, up or a number of milliseconds", 1, 3_600_000);
    }
}
