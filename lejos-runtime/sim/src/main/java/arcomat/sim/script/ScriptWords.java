package arcomat.sim.script;

import arcomat.sim.device.Key;
import arcomat.sim.device.SensorName;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The words that a script may go on with. */
public final class ScriptWords {
    private ScriptWords() {}

    /**
     * Those of which one may follow; none where a number has to, or nothing.
     *
     * @param line as far as it is written, up to the end of a word
     */
    public static List<String> after(String line) {
        List<String> words = Word.split(line, 1).stream().map(Word::text).toList();
        boolean button = words.size() > 1 && words.get(1).equals("button");
        return switch (words.size()) {
            case 1 -> actions();
            case 2 -> button ? names(Key.values()) : values(words.get(1));
            case 3 -> button ? List.of("down", "up") : List.of();
            default -> List.of();
        };
    }

    private static List<String> actions() {
        List<String> actions = new ArrayList<>(names(SensorName.values()));
        actions.addAll(List.of("button", "end"));
        return actions;
    }

    private static List<String> values(String port) {
        return names(SensorName.values()).contains(port) ? Values.words() : List.of();
    }

    private static List<String> names(Enum<?>[] constants) {
        return Arrays.stream(constants).map(Enum::name).toList();
    }
}
