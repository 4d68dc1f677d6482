package arcomat.fuzz;

import java.util.ArrayList;
import java.util.List;

/**
 * Changes models so that most of them stay readable and many stay right: other names, numbers,
 * types, operators and expressions, a line more or less, other stereotypes.
 */
final class Variation {
    private static final String NUMBER = "\\d[\\d.]*|true|false";
    private static final String SMALL_NAME =
            "(?!(?:package|import|component|port|in|out|connect|automaton|state|initial|variable"
                + "|timing|test|testsuite|input|expect|enum|class|classdiagram|table)\\b)[a-z_]\\w*";
    private static final String[] NUMBERS = {
        "0",
        "1",
        "2",
        "-1",
        "3",
        "127",
        "128",
        "255",
        "300",
        "2147483647",
        "-2147483648",
        "1.5",
        "9223372036854775807L",
        "0.1",
        "1e308",
        "0x7f",
        "'x'",
        "\"a\\\"b\"",
        "true",
        "false",
        "5L",
        "2.5f",
        "(byte) 300",
        "(char) 65",
        "-7 % 3",
        "5 / 2",
        "1 / 3.0",
        "(int) 2.9",
        "-(-3)",
        "'\\u0041'",
    };
    private static final String[] TYPES = {
        "Integer", "int", "Integer[0..3]", "Integer[-2..2]", "byte", "short", "long", "Long",
        "Long[-3..3]", "char", "float", "double", "Double", "boolean", "Boolean", "String",
        "byte[0..100]", "Integer[1..9]",
    };
    private static final String[] EXPRESSIONS = {
        "(%s)",
        "(%s + 1)",
        "(%s - 1)",
        "-%s",
        "(%s * 2)",
        "(%s / 2)",
        "(%s %% 3)",
        "(3 / %s)",
        "(1 %% %s)",
        "(byte) %s",
        "(int) %s",
        "(char) %s",
        "(long) %s",
        "(double) %s",
        "(float) %s",
        "(short) %s",
        "!%s",
        "(%s == %s)",
        "(%s != %s)",
        "(%s < 2)",
        "(%s >= 1.5)",
        "(%s && true)",
        "(%s || %s)",
        "(%s implies %s)",
        "(%s <=> true)",
        "(if true then %s else %s)",
        "(%s == %s ? %s : %s)",
        "(%s isin {%s})",
        "(%s isin {1, 2})",
        "alt {%s, %s}",
        "[%s]",
        "--",
        "?",
        "(%s == --)",
        "(%s + \"\")",
        "(%s * 1000000)",
        "(1.0 / %s)",
        "%s + %s",
    };
    private static final String[] AUTOMATA = {
        "<<completion = \"chaos\">> automaton",
        "<<completion = \"output\">> automaton",
        "<<completion = \"ignore\">> automaton",
        "<<completion = \"error\">> automaton",
        "<<omitted = \"free\">> automaton",
        "<<completion = \"output\", omitted = \"free\">> automaton",
        "timing instant; automaton",
        "timing delayed; automaton",
        "timing untimed; automaton",
        "Integer constant = 7; automaton",
        "autoconnect type; automaton",
    };
    private static final String[] DIRECTIONS = {
        "in",
        "out",
        "<<total>> in",
        "<<total>> out",
        "<<delay = \"0\">> out",
        "<<delay = \"1\">> out",
        "<<state>> in",
    };

    private final Dice dice;

    Variation(long seed) {
        this.dice = new Dice(seed);
    }

    ModelSet apply(ModelSet set) {
        String path = dice.path(set);
        ModelSet changed = set;
        for (int i = dice.below(3); i >= 0; i--) {
            if (dice.below(5) == 0) {
                changed = dice.renamedEverywhere(changed);
            } else if (changed.files().containsKey(path)) {
                changed = changed.with(path, changed(changed.text(path)));
            }
        }
        return changed;
    }

    private String changed(String text) {
        return switch (dice.below(12)) {
            case 0, 1 -> line(text);
            case 2, 3 -> dice.replaceOne(text, SMALL_NAME, t -> dice.token(text, SMALL_NAME));
            case 4 -> dice.replaceOne(text, "[A-Z]\\w*", t -> dice.token(text, "[A-Z]\\w*"));
            case 5 -> dice.replaceOne(text, NUMBER, t -> dice.one(NUMBERS));
            case 6 -> dice.replaceOne(text, "[A-Z]\\w*|int|boolean", t -> dice.one(TYPES));
            case 7 -> operator(text);
            case 8, 9 -> dice.replaceOne(text, SMALL_NAME + "|" + NUMBER, this::expression);
            case 10 -> dice.replaceOne(text, "automaton", t -> dice.one(AUTOMATA));
            default -> dice.replaceOne(text, "in|out", t -> dice.one(DIRECTIONS));
        };
    }

    private String expression(String token) {
        return dice.one(EXPRESSIONS).replace("%s", token).replace("%%", "%");
    }

    private String operator(String text) {
        return switch (dice.below(3)) {
            case 0 ->
                    dice.replaceOne(text, "==|!=|<=|>=|[<>]", t -> dice.one("==", "!=", "<", ">="));
            case 1 -> dice.replaceOne(text, "[-+*/%]", t -> dice.one("+", "-", "*", "/", "%"));
            default -> dice.replaceOne(text, "&&|\\|\\|", t -> dice.one("&&", "||", "implies"));
        };
    }

    /** A line that ends an element once more, somewhere else, or not at all. */
    private String line(String text) {
        List<String> lines = new ArrayList<>(text.lines().toList());
        List<Integer> whole = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (lines.get(i).endsWith(";")) {
                whole.add(i);
            }
        }
        if (whole.isEmpty()) {
            return text;
        }
        int from = dice.one(whole);
        int to = dice.one(whole);
        switch (dice.below(3)) {
            case 0 -> lines.add(to, lines.get(from));
            case 1 -> lines.remove(from);
            default -> lines.add(to, lines.remove(from));
        }
        return String.join("\n", lines) + "\n";
    }
}
