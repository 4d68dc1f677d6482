package arcomat.analysis.automaton;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * Random automata over numbers without a range, and what somebody makes of them: the same in other
 * words, most of them with one edit. The same seed gives the same two.
 */
public final class EditedAutomata {
    private static final List<List<String>> OTHER_WORDS =
            List.of(
                    List.of("n > v", "v < n"),
                    List.of("w == v", "v == w"),
                    List.of("n + v", "v + n"),
                    List.of("v + 1", "1 + v"),
                    List.of("v < 3", "3 > v"));

    private static final List<String> COMPLETIONS =
            List.of("ignore", "ignore", "chaos", "chaos", "output", "error");

    private final Random random;
    private final long base;

    private EditedAutomata(long seed) {
        random = new Random(seed);
        base = seed * 4 + 1 + random.nextInt(3); // none that handles events
    }

    /** The texts of components {@code Left}, which is the edited one, and {@code Right}. */
    public static List<String> texts(long seed) {
        EditedAutomata edited = new EditedAutomata(seed);
        String text = new RandomTraps(edited.base, true).text();
        String right = seed % 2 == 0 ? text : text.replace("<<total>>", "");
        String left = edited.inOtherWords(edited.edited(right));
        String completion = edited.any(COMPLETIONS);
        String other = edited.random.nextInt(4) > 0 ? completion : edited.any(COMPLETIONS);
        return List.of(named(left, "Left", completion), named(right, "Right", other));
    }

    private static String named(String text, String name, String completion) {
        return text.replace("component Random", "component " + name)
                .replace("\"ignore\"", "\"" + completion + "\"");
    }

    private <T> T any(List<T> all) {
        return all.get(random.nextInt(all.size()));
    }

    /** Without a transition, with a stronger guard, or with a transition of another automaton. */
    private String edited(String text) {
        List<String> lines = new ArrayList<>(text.lines().toList());
        int which = any(transitions(lines));
        switch (random.nextInt(5)) {
            case 0 -> lines.remove(which);
            case 1 -> lines.set(which, lines.get(which).replaceFirst("\\[", "[v != 7 && "));
            case 2 -> {
                List<String> others = new RandomTraps(base + 4000, true).text().lines().toList();
                lines.set(which, others.get(any(transitions(others))));
            }
            default -> {}
        }
        return String.join("\n", lines);
    }

    private static List<Integer> transitions(List<String> lines) {
        return IntStream.range(0, lines.size())
                .filter(i -> lines.get(i).contains("->"))
                .boxed()
                .toList();
    }

    private String inOtherWords(String text) {
        String other = text;
        if (random.nextInt(4) > 0) {
            for (List<String> each : OTHER_WORDS) {
                other = other.replace(each.get(0), each.get(1));
            }
        }
        return random.nextInt(3) == 0 ? other.replaceAll("\\bv\\b", "total") : other;
    }
}
