package arcomat.analysis.automaton;

import java.util.List;
import java.util.Random;

/**
 * Random automata that compute with numbers of all types, mostly near the ends of what these can
 * hold; half of the guards can never be true.
 */
final class RandomArithmetic {
    private static final List<String> WHOLE =
            List.of(
                    "0",
                    "1",
                    "2",
                    "3",
                    "7",
                    "-1",
                    "-2",
                    "100",
                    "-128",
                    "255",
                    "65535",
                    "65536",
                    "715827883",
                    "1073741824",
                    "2147483647",
                    "-2147483647",
                    "-2147483648");
    private static final List<String> REAL =
            List.of(
                    "0.0",
                    "-0.0",
                    "1.0",
                    "0.1",
                    "0.1f",
                    "16777217.0",
                    "1.0E300",
                    "-1.0E300",
                    "1.7976931348623157E308",
                    "3.4028235E38f",
                    "4.9E-324",
                    "2147483647.5");

    private final Random random;
    private final boolean remembers;

    /**
     * @param remembers whether it has variables
     */
    RandomArithmetic(long seed, boolean remembers) {
        this.random = new Random(seed);
        this.remembers = remembers;
    }

    String text() {
        StringBuilder lines = new StringBuilder();
        for (int i = 3 + random.nextInt(4); i > 0; i--) {
            lines.append("    ").append(transition()).append('\n');
        }
        return """
        component Random(Integer k) {
          port <<total>> in Integer a, <<total>> in Integer b, <<total>> in Integer[-3..9] r,
               <<total>> in Long l, <<total>> in char c, <<total>> in byte y,
               <<total>> in Double d, <<total>> in float f, out Integer x;

          <<completion = "ignore">> automaton {
            state s0, s1;
            %s
            initial s0;
        %s  }
        }
        """
                .formatted(
                        remembers
                                ? "variable Integer v = 1;\n    variable Integer[0..9] w = 2;"
                                : "",
                        lines);
    }

    private String transition() {
        String states = remembers ? one("s0", "s0 -> s1", "s1", "s1 -> s0") : "s0";
        String effect =
                remembers
                        ? one(
                                " / {v = " + whole(1) + "}",
                                " / {v = v + " + one("1", "2", "-1") + ", x = v}",
                                " / {w = w " + one("+", "-") + " 1}",
                                " / {w = r}",
                                "")
                        : one("", " / {x = " + whole(1) + "}");
        return states + " [" + condition() + "]" + effect + ";";
    }

    private String one(String... some) {
        return some[random.nextInt(some.length)];
    }

    private String one(List<String> some) {
        return some.get(random.nextInt(some.size()));
    }

    private String condition() {
        String x = whole(1);
        String k = one(WHOLE);
        String y = whole(1);
        String l = "(l " + one("+", "-", "*") + " " + one("1L", "-1L", "3L", "2147483648L") + ")";
        return switch (random.nextInt(20)) {
            case 0 -> x + " + " + k + relation() + x;
            case 1 -> x + " + " + k + relation() + x + " && " + x + relation() + one(WHOLE);
            case 2 -> x + " * " + k + relation() + one(WHOLE);
            case 3 -> x + " % " + nonZero() + relation() + one(WHOLE);
            case 4 -> x + " / " + nonZero() + relation() + one(WHOLE);
            case 5 -> "(byte) " + x + relation() + one("127", "-129", "128", "-128", y);
            case 6 -> "-" + x + relation() + x + " && " + x + relation() + one(WHOLE);
            case 7 -> x + " - " + y + relation() + y + " - " + x;
            case 8 -> l + relation() + "l && " + l + relation() + one("l", "0L", "5L", "-7L");
            case 9 -> "(int) " + l + relation() + x + " && l" + relation() + one("0L", "99L");
            case 10 -> "~" + x + relation() + "-" + x + " - " + one("1", "0");
            case 11 -> x + " / " + y + relation() + one(WHOLE) + " && " + y + relation() + "0";
            case 12 -> "(char) (c + 1)" + relation() + "c && c" + relation() + one(WHOLE);
            case 13 -> comparison() + " && " + comparison();
            case 14 -> comparison() + " && !(" + comparison() + " || " + comparison() + ")";
            case 15 -> "!(" + comparison() + " implies " + comparison() + ")";
            case 16 -> x + " * 2 % 2" + relation() + one("0", "1", "-1");
            case 18 -> "(byte) (9223372036854775800L + r)" + relation() + one("0", "-8", "1", "r");
            case 17 -> "(a < 0 ? -a : a)" + relation() + one("0", "1", "b");
            default -> x + relation() + y + " && " + y + relation() + whole(1);
        };
    }

    /** Of a port of floating point with a constant, or of whole numbers with one of these. */
    private String comparison() {
        String left = one("d", "d", "f", "a", "y", "c", "d");
        String compared = left + relation() + one(REAL);
        return switch (random.nextInt(8)) {
            case 0, 1 -> "!(" + compared + ")";
            case 2 -> left + relation() + left;
            case 3 -> one(REAL) + relation() + left;
            default -> compared;
        };
    }

    private String relation() {
        return one(" < ", " <= ", " > ", " >= ", " == ", " != ");
    }

    private String nonZero() {
        String number = one(WHOLE);
        return number.equals("0") ? "5" : number;
    }

    private String whole(int depth) {
        if (depth == 0 || remembers || random.nextInt(3) == 0) {
            return remembers
                    ? one("a", "b", "v", "v", "w", "r", "k")
                    : one("a", "b", "r", "c", "y", "k");
        }
        String x = whole(depth - 1);
        return switch (random.nextInt(7)) {
            case 0 -> "(" + x + " + " + one(WHOLE) + ")";
            case 1 -> "(" + x + " - " + whole(depth - 1) + ")";
            case 2 -> "(" + x + " * " + one(WHOLE) + ")";
            case 3 -> "(" + x + " * r)";
            case 4 -> "((short) " + x + ")";
            case 5 -> "(" + x + " % " + nonZero() + ")";
            default -> "(-" + x + ")";
        };
    }
}
