package arcomat.analysis.automaton;

import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.models.ReadModels;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Random;

/** Random automata that send little, and often stop to do so; the same seed gives the same one. */
final class RandomTraps {
    private static final List<String> SOURCES = List.of("s0", "s0", "s1", "s1", "s2");
    private static final List<String> TARGETS = List.of("s0", "s1", "s1", "s2", "s2");
    private static final List<String> GUARDS =
            List.of(
                    "",
                    "",
                    " [n > v]",
                    " [n >= w]",
                    " [v < 2]",
                    " [v > 0]",
                    " [w == v]",
                    " [v == 3]",
                    " [w > v && n == v]",
                    " [n == v || b == --]",
                    " [v != 1 && n != w]",
                    " [4 / v == 2]",
                    " [n + v > 4]",
                    " [n < v - w]",
                    " [on && v < 3]",
                    " [key && w < 2]",
                    " [key == --]",
                    " [v > 3 && v < 2]");
    private static final List<String> INPUTS =
            List.of(
                    "",
                    "",
                    " {b == true}",
                    " {b == --}",
                    " {n == ?}",
                    " {n == 1}",
                    " {b == false}");
    private static final List<String> SILENT =
            List.of("", "", "v = n", "w = v", "v = 0", "w = 3", "v = w, w = 1", "v = 3", "w = n");

    /** These leave a range where there is one, unless the guard prevents it. */
    private static final List<String> GROWING =
            List.of(
                    " [v < 3]/ {v = v + 1}",
                    " [v > 0]/ {v = v - 1}",
                    " [w < 3 && n > 1]/ {w = w + 1}");

    private static final List<String> SENDING =
            List.of("x = 1", "x = v", "x = n, v = n", "y = true, v = w", "y = ?, w = 0");

    private final Random random;
    private final boolean wide;
    private final boolean events;
    private final boolean lively;

    /**
     * @param wide whether numbers have no range
     */
    RandomTraps(long seed, boolean wide) {
        this.random = new Random(seed);
        this.wide = wide;
        this.events = seed % 4 == 0;
        this.lively = seed % 3 > 0;
    }

    /** The automaton, to be analyzed. */
    static Subject subject(long seed, boolean wide) {
        return subject(new RandomTraps(seed, wide).text());
    }

    /** The same with a second beginning in the same state. */
    static Subject ofTwoBeginnings(long seed) {
        String first = "initial s0;";
        String text = new RandomTraps(seed, false).text();
        return subject(text.replace(first, first + " initial s0 / {v = 3};"));
    }

    private static Subject subject(String text) {
        SourceFile source = new SourceFile("Random.arc", text);
        Component component = ReadModels.model(source).components().get(0);
        Automaton automaton = ((Component.Atomic) component.body()).automata().get(0);
        return Subject.of(component, automaton, List.of());
    }

    String text() {
        StringBuilder lines = new StringBuilder();
        for (int i = 3 + random.nextInt(8); i > 0; i--) {
            lines.append("    ").append(line()).append('\n');
        }
        String type = wide ? "Integer" : "Integer[0..3]";
        return """
        component Random {
          %s
          port in Boolean b, in %s n, %s in Boolean on, %s in Boolean key,
               out Integer x, out Boolean y;

          <<completion = "ignore">> automaton {
            state s0, s1, s2;
            variable %s v = 1;
            variable %s w = 2;
            initial s0;
        %s  }
        }
        """
                .formatted(
                        events ? "timing untimed;" : "",
                        type,
                        events ? "" : "<<total>>",
                        events ? "<<state>>" : "",
                        type,
                        type,
                        lines);
    }

    private String line() {
        String move = one(SOURCES) + " -> " + one(TARGETS);
        String input = one(INPUTS);
        if (random.nextInt(4) == 0) {
            return move + one(GROWING).replace("/", input + " /") + ";";
        }
        String effect = random.nextInt(4) < (lively ? 3 : 1) ? one(SENDING) : one(SILENT);
        return move + one(GUARDS) + input + (effect.isEmpty() ? "" : " / {" + effect + "}") + ";";
    }

    private String one(List<String> all) {
        return all.get(random.nextInt(all.size()));
    }
}
