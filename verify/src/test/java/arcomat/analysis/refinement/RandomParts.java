package arcomat.analysis.refinement;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Two random compositions that are alike, of parts that calculate with what other parts send: with
 * messages that may be missing, states, delays, choices, and steps that go wrong.
 */
final class RandomParts {
    private static final List<String> GUARDS =
            List.of(
                    "x > %d",
                    "x < %d",
                    "x == %d",
                    "x - z > %d",
                    "x + z == %d",
                    "z >= x + %d",
                    "x %% 3 == %d",
                    "2 * x - z <= %d",
                    "x != z");
    private static final List<String> MESSAGES =
            List.of("x", "z", "x + %d", "x - z", "z - %d", "2 * x", "%d", "x + z", "6 / x", "--");
    private static final List<String> COMPLETIONS =
            List.of("ignore", "ignore", "ignore", "error", "output", "chaos");

    private final Random random;
    private final List<String> heads = new ArrayList<>();
    private final List<List<String>> left = new ArrayList<>();
    private final List<List<String>> right = new ArrayList<>();
    private final boolean again;

    RandomParts(long seed) {
        random = new Random(seed);
        int size = 2 + random.nextInt(2);
        for (int i = 0; i < size; i++) {
            heads.add(head());
            List<String> rows = new ArrayList<>();
            int some = 1 + random.nextInt(3);
            for (int row = 0; row < some; row++) {
                rows.add(row(row == 0));
            }
            left.add(rows);
            right.add(new ArrayList<>(rows));
        }
        List<String> changed = right.get(random.nextInt(size));
        if (random.nextInt(3) > 0) {
            changed.set(random.nextInt(changed.size()), row(true));
        } else {
            changed.add(row(false));
        }
        again = random.nextInt(4) == 0;
    }

    private String head() {
        String timing = random.nextInt(5) == 0 ? "" : "timing instant; ";
        return "%sport in Integer x, in Integer z, out Integer y; <<completion = \"%s\">> "
                .formatted(timing, drawn(COMPLETIONS));
    }

    private String row(boolean first) {
        String from = first || random.nextBoolean() ? "s" : "t";
        String to = random.nextInt(3) == 0 ? "t" : from;
        return from + " -> " + to + guard() + sends();
    }

    private String guard() {
        return switch (random.nextInt(6)) {
            case 0 -> " {x == ?}";
            case 1 -> " {x == --}";
            case 2 -> "";
            default -> " [" + drawn(GUARDS) + "]";
        };
    }

    private String sends() {
        return random.nextInt(6) == 0 ? ";" : " / {y = " + drawn(MESSAGES) + "};";
    }

    private String drawn(List<String> from) {
        String text = from.get(random.nextInt(from.size()));
        return text.contains("%") ? text.formatted(random.nextInt(5) - 1) : text;
    }

    /**
     * The texts of {@code Left} and {@code Right}.
     *
     * @param type of the messages from outside
     */
    List<String> models(String type) {
        return List.of(text("Left", left, type), text("Right", right, type));
    }

    private String text(String name, List<List<String>> parts, String type) {
        StringBuilder lines = new StringBuilder("component " + name + " {\n");
        lines.append(
                "  port in %s p, in %s q, out Integer o, out Integer r;\n".formatted(type, type));
        String before = "p";
        for (int i = 0; i < parts.size(); i++) {
            String rows = String.join(" ", parts.get(i));
            lines.append(
                    "  component P%d { %s automaton { state s, t; initial s; %s } }\n"
                            .formatted(i, heads.get(i), rows));
            lines.append("  component P%d p%d;\n".formatted(i, i));
            lines.append("  connect %s -> p%d.x;\n  connect q -> p%d.z;\n".formatted(before, i, i));
            before = "p" + i + ".y";
        }
        lines.append("  connect " + before + " -> o;\n");
        lines.append(again ? "  connect p -> r;\n" : "");
        return lines.append("}\n").toString();
    }
}
