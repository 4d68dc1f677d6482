package arcomat.fuzz;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;

/**
 * Damages models as people and machines do: a token too many or too few, a wrong name, a wrong
 * type, a line of another model, a text that ends early, characters that nobody typed, a file that
 * is gone. The same seed does the same damage.
 */
public final class Damage {
    private static final String NAME = "[A-Za-z_]\\w*";
    private static final String[] NUMBERS = {
        "0",
        "1",
        "-1",
        "2147483647",
        "2147483648",
        "-2147483648",
        "9223372036854775807L",
        "1.5",
        "1e308",
        "1e999",
        "0x7f",
        "010",
        "'x'",
        "'\\u0041'",
        "\"\"",
        "\"a\\\"b\"",
        "true",
        "null",
        "1L",
        "1.0f",
        "100000",
        "5 / 2",
        "-7 % 3",
        "(1 / 0)",
        "(long) 3",
        "(byte) 300",
        "(char) 65",
    };
    private static final String[] TYPES = {
        "Integer",
        "int",
        "Integer[0..3]",
        "Integer[2..2]",
        "Integer[5..1]",
        "byte",
        "short",
        "long",
        "Long",
        "Long[-3..3]",
        "char",
        "Character",
        "float",
        "double",
        "Double",
        "boolean",
        "Boolean",
        "String",
        "Object",
        "Integer[]",
        "List<Integer>",
        "byte[0..200]",
        "int[-1..1]",
        "char[0..9]",
        "void",
    };
    private static final String[] OPERATORS = {
        "+", "-", "*", "/", "%", "==", "!=", "<", "<=", ">", ">=", "&&", "||", "implies", "<=>",
                "?",
        "isin", "=", "--", ".", ",", ";", "->", ":", "[", "]", "{", "}", "(", ")", "alt", "++",
    };
    private static final String[] PIECES = {
        "<<total>> ",
        "<<delay = \"0\">> ",
        "<<delay = \"1\">> ",
        "<<state>> ",
        "<<platform>> ",
        "<<completion = \"chaos\">> ",
        "<<completion = \"error\">> ",
        "<<completion = \"ignore\">> ",
        "<<completion = \"output\">> ",
        "<<omitted = \"free\">> ",
        "<<layer = \"sensors\">> ",
        "<<suppress = \"ARC0104: so\">> ",
        "<<deploy>> ",
        "timing instant;\n",
        "timing untimed;\n",
        "timing delayed;\n",
        "autoconnect type;\n",
        "autoconnect port;\n",
        "variable Integer v = 2, w;\n",
        "variable double d;\n",
        "variable String text = \"a\";\n",
        "initial ",
        "-- ",
        "? ",
        "alt {",
        "* ",
        "! ",
        "[1, 2] ",
        "abstract ",
        "deploy ",
        "port in Integer extra;\n",
        "port out Integer more;\n",
        "automaton { state s; initial s; }\n",
        "component X { port in int a; }\n",
        "if true then 1 else 2 ",
        "true ? 1 : 2 ",
        "new A() ",
        "extends A ",
        "refines A ",
        "<T> ",
        "<T extends Integer> ",
        "(Integer n) ",
        "(1) ",
        "[",
        "import a.B;\n",
        "import a.*;\n",
        "inv x : true;\n",
        "compute { }\n",
        "call f() ",
        "autoinstantiate on;\n",
        "table { in a; out b; | * | => | 1 |; }\n",
        "[a -> b] ",
    };
    private static final String[] ODD = {
        "\0",
        "\u0007",
        "\u001b[31m",
        "\ud800",
        "\udc00",
        "\ud83d\ude00",
        "\ufeff",
        "\u202e",
        "\u2028",
        "\u00a0",
        "\u0085",
        "\t",
        "\r",
        "\f",
        "\u000b",
        "\u200b",
        "\u00e9",
        "\u0130",
        "\u00df",
        "\\",
        "\\u002a/",
        "*/",
        "/*",
        "//",
        "\"",
        "'",
        "`",
        "#",
        "@",
        "${x}",
        "<#if>",
        "\uffff",
        "\u01c5",
    };

    private final List<ModelSet> donors;
    private final Dice dice;

    /**
     * @param donors where lines and names of other models come from
     */
    public Damage(List<ModelSet> donors, long seed) {
        this.donors = donors;
        this.dice = new Dice(seed);
    }

    /** The set with a few damages, most of them in one file. */
    public ModelSet apply(ModelSet set) {
        String path = dice.path(set);
        ModelSet damaged = set;
        for (int i = dice.below(3); i >= 0; i--) {
            if (damaged.files().containsKey(path)) {
                damaged = once(damaged, path);
            }
            if (dice.below(4) == 0 && !damaged.files().isEmpty()) {
                path = dice.path(damaged);
            }
        }
        return damaged;
    }

    /** The text of one file with a few damages. */
    public String apply(String text) {
        String damaged = text;
        for (int i = dice.below(3); i >= 0; i--) {
            damaged = damaged(damaged);
        }
        return damaged;
    }

    private ModelSet once(ModelSet set, String path) {
        return switch (dice.below(20)) {
            case 0 -> set.without(path);
            case 1 -> dice.renamedEverywhere(set);
            case 2 -> set.with(path.replace(".arc", ".ioautomaton"), set.text(path));
            default -> set.with(path, damaged(set.text(path)));
        };
    }

    private String damaged(String text) {
        List<MatchResult> tokens = Dice.tokens(text);
        if (tokens.isEmpty()) {
            return dice.one(PIECES) + text;
        }
        MatchResult token = dice.one(tokens);
        return switch (dice.below(16)) {
            case 0 -> Dice.replace(text, token, "");
            case 1 -> Dice.replace(text, token, token.group() + " " + token.group());
            case 2 -> swapped(text, token, dice.one(tokens));
            case 3 -> text.substring(0, dice.below(text.length() + 1));
            case 4, 5 -> line(text, true);
            case 6 -> line(text, false);
            case 7 -> insert(text, dice.one(ODD));
            case 8, 9 -> Dice.replace(text, token, token.group() + " " + dice.one(PIECES));
            case 10 -> dice.replaceOne(text, "[A-Z]\\w*|int|double|long", t -> dice.one(TYPES));
            case 11 -> dice.replaceOne(text, "\\d.*|[a-z]\\w*", t -> dice.one(NUMBERS));
            case 12, 13 -> dice.replaceOne(text, "\\W.*", t -> dice.one(OPERATORS));
            case 14 -> dice.replaceOne(text, "\\w+", t -> dice.token(anyText(), NAME));
            default -> dice.replaceOne(text, NAME, t -> dice.token(text, NAME));
        };
    }

    /** A line of whatever model, at the place of another one or beside it. */
    private String line(String text, boolean beside) {
        List<String> lines = new ArrayList<>(text.lines().toList());
        List<String> others = (dice.below(2) == 0 ? text : anyText()).lines().toList();
        int at = dice.below(lines.size());
        String other = others.isEmpty() ? "" : dice.one(others);
        if (beside) {
            lines.add(at, other);
        } else {
            lines.set(at, other);
        }
        return String.join("\n", lines) + "\n";
    }

    private String insert(String text, String piece) {
        int at = dice.below(text.length() + 1);
        return text.substring(0, at) + piece + text.substring(at);
    }

    private static String swapped(String text, MatchResult one, MatchResult other) {
        MatchResult first = one.start() < other.start() ? one : other;
        MatchResult second = first == one ? other : one;
        return Dice.replace(Dice.replace(text, second, first.group()), first, second.group());
    }

    private String anyText() {
        ModelSet donor = dice.one(donors);
        return donor.text(dice.path(donor));
    }
}
