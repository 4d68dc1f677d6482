package arcomat.benchmarks.data;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Whether one automaton refines another, both with one state, no memory, and inputs {@code p} and
 * {@code q} of 32 bits: told to the tool and to a solver from one description. All of them hold.
 *
 * @param name of the family
 * @param size how many rows
 * @param parts of the left side that {@code p} goes through first, each adds 3; 0 where it is no
 *     composition
 */
record DataQuestion(String name, int size, int parts, List<Row> rows) {
    /**
     * A transition of both sides, and what it sends.
     *
     * @param left guard of the left side
     * @param right the same of the right side, written otherwise
     * @param first the left one for the solver
     * @param second the right one for the solver
     */
    record Row(String left, String right, String first, String second) {}

    DataQuestion {
        rows = List.copyOf(rows);
    }

    String label() {
        return name + " " + size;
    }

    /** The components {@code Left}, {@code Right} and what they are made of. */
    List<String> models() {
        String left = automaton(parts == 0 ? "Left" : "Core", Row::left);
        String right = automaton("Right", Row::right);
        return parts == 0 ? List.of(left, right) : List.of(left, right, PART, whole());
    }

    private static final String PART =
            """
            component Adder {
              timing instant;
              port <<total>> in Integer x, <<total>> out Integer y;
              <<completion = "error">> automaton { state s; initial s; s / {y = x + 3}; }
            }
            """;

    private String whole() {
        StringBuilder text = new StringBuilder("component Left {\n" + PORTS);
        text.append("  component Core core;\n");
        String before = "p";
        for (int i = 0; i < parts; i++) {
            text.append("  component Adder a%d;\n  connect %s -> a%d.x;\n".formatted(i, before, i));
            before = "a" + i + ".y";
        }
        text.append("  connect " + before + " -> core.p;\n");
        return text.append("  connect q -> core.q;\n  connect core.o -> o;\n}\n").toString();
    }

    private static final String PORTS =
            "  port <<total>> in Integer p, <<total>> in Integer q, out Integer o;\n";

    private interface Guard {
        String of(Row row);
    }

    private String automaton(String component, Guard guard) {
        StringBuilder text = new StringBuilder("component " + component + " {\n");
        text.append("  timing instant;\n").append(PORTS);
        text.append("  <<completion = \"ignore\">> automaton {\n    state s;\n    initial s;\n");
        for (int i = 0; i < rows.size(); i++) {
            text.append("    s [%s] / {o = %d};\n".formatted(guard.of(rows.get(i)), i));
        }
        return text.append("  }\n}\n").toString();
    }

    /** As SMT-LIB: each question is unsatisfiable. */
    String script() {
        List<String> lines = new ArrayList<>();
        lines.add("(set-option :global-declarations true)");
        lines.add("(set-logic QF_BV)");
        lines.add("(declare-fun p () (_ BitVec 32))(declare-fun q () (_ BitVec 32))");
        for (Row row : rows) {
            ask(row.first() + " (not " + row.second() + ")", lines);
        }
        ask("(not " + any(Row::first) + ") " + any(Row::second), lines);
        return String.join("\n", lines) + "\n";
    }

    private String any(Guard guard) {
        return rows.stream().map(guard::of).collect(Collectors.joining(" ", "(or false ", ")"));
    }

    private static void ask(String conditions, List<String> lines) {
        lines.add("(push 1)(assert (and " + conditions + "))(check-sat)(pop 1)");
    }
}
