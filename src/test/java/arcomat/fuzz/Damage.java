package arcomat.fuzz;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Damages models as people and machines do: a token too many or too few, a wrong name, a wrong
 * type, a line of another model, a text that ends early, characters that nobody typed, a file that
 * is gone. The same seed does the same damage.
 */
final class Damage {
    private static final Pattern TOKEN =
            Pattern.compile(
                    "//[^\n]*|/\\*.*?\\*/|\"[^\"\n]*\"|\\d+(?:\\.\\d+)?|\\w+|==|->|=>|--|&&|\\|\\||"
                            + "[<>!]=|\\.\\.|\\S",
                    Pattern.DOTALL);
    private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");
    private static final String[] NUMBERS = {
        "0", "1", "-1", "2147483647", "2147483648", "-2147483648", "9223372036854775807L", "1.5",
        "1e308", "1e999", "0x7f", "010", "'x'", "'\\u0041'", "\"\"", "\"a\\\"b\"", "true", "null",
        "1L", "1.0f", "100000", "5 / 2", "-7 % 3", "(1 / 0)", "(long) 3", "(byte) 300", "(char) 65",
    };
    private static final String[] TYPES = {
        "Integer", "int", "Integer[0..3]", "Integer[2..2]", "Integer[5..1]", "byte", "short",
        "long", "Long", "Long[-3..3]", "char", "Character", "float", "double", "Double", "boolean",
        "Boolean", "String", "Object", "Integer[]", "List<Integer>", "byte[0..200]", "int[-1..1]",
        "char[0..9]", "void",
    };
    private static final String[] OPERATORS = {
        "+", "-", "*", "/", "%", "==", "!=", "<", "<=", ">", ">=", "&&", "||", "implies", "<=>", "?",
        "isin", "=", "--", ".", ",", ";", "->", ":", "[", "]", "{", "}", "(", ")", "alt", "++",
    };
    private static final String[] JAVA_NAMES = {
        "class", "String", "Main", "Object", "step", "this", "int_", "Integer", "state", "java",
        "arcomat", "rt", "run", "main", "System", "goto", "enum", "assert", "Math", "choice", "reset",
        "Boolean", "Check", "Choice", "ModelError", "INITIAL", "input", "output", "getClass", "wait",
        "hashCode", "notify", "toString", "void_", "_", "__", "$", "a$b", "x1", "X1", "equals", "const",
        "clear", "values", "valueOf", "ordinal", "name", "length", "Override", "slice", "seed",
    };
    private static final String[] PIECES = {
        "<<total>> ", "<<delay = \"0\">> ", "<<delay = \"1\">> ", "<<state>> ", "<<platform>> ",
        "<<completion = \"chaos\">> ", "<<completion = \"error\">> ", "<<completion = \"ignore\">> ",
        "<<completion = \"output\">> ", "<<omitted = \"free\">> ", "<<layer = \"sensors\">> ",
        "<<suppress = \"ARC0104: so\">> ", "<<deploy>> ", "timing instant;\n", "timing untimed;\n",
        "timing delayed;\n", "autoconnect type;\n", "autoconnect port;\n",
        "variable Integer v = 2, w;\n", "variable double d;\n", "variable String text = \"a\";\n",
        "initial ", "-- ", "? ", "alt {", "* ", "! ", "[1, 2] ", "abstract ", "deploy ",
        "port in Integer extra;\n", "port out Integer more;\n", "automaton { state s; initial s; }\n",
        "component X { port in int a; }\n", "if true then 1 else 2 ", "true ? 1 : 2 ", "new A() ",
        "extends A ", "refines A ", "<T> ", "<T extends Integer> ", "(Integer n) ", "(1) ", "[",
        "import a.B;\n", "import a.*;\n", "inv x : true;\n", "compute { }\n", "call f() ",
        "autoinstantiate on;\n", "table { in a; out b; | * | => | 1 |; }\n", "[a -> b] ",
    };
    private static final String[] ODD = {
        "\0", "\u0007", "\u001b[31m", "\ud800", "\udc00", "\ud83d\ude00", "\ufeff", "\u202e", "\u2028",
        "\u00a0", "\u0085", "\t", "\r", "\f", "\u000b", "\u200b", "\u00e9", "\u0130", "\u00df", "\\",
        "\\u002a/", "*/", "/*", "//", "\"", "'", "`", "#", "@", "${x}", "<#if>", "\uffff", "\u01c5",
    };

    private final List<ModelSet> donors;
    private final Random random;

    Damage(List<ModelSet> donors, long seed) {
        this.donors = donors;
        this.random = new Random(seed);
    }

    /** The set with a few damages, most of them in one file. */
    ModelSet apply(ModelSet set) {
        String path = anyPath(set);
        ModelSet damaged = set;
        for (int i = random.nextInt(3); i >= 0; i--) {
            if (damaged.files().containsKey(path)) {
                damaged = once(damaged, path);
            }
            if (random.nextInt(4) == 0 && !damaged.files().isEmpty()) {
                path = anyPath(damaged);
            }
        }
        return damaged;
    }

    private ModelSet once(ModelSet set, String path) {
        return switch (random.nextInt(40)) {
            case 0 -> set.without(path);
            case 1, 2, 3, 4, 5 -> renamedEverywhere(set);
            case 6 -> set.with(path.replace(".arc", ".ioautomaton"), set.text(path));
            default -> set.with(path, damaged(set, set.text(path)));
        };
    }

    private String damaged(ModelSet set, String text) {
        List<MatchResult> tokens = tokens(text);
        if (tokens.isEmpty()) {
            return pick(PIECES) + text;
        }
        MatchResult token = pick(tokens);
        return switch (random.nextInt(24)) {
            case 0 -> replace(text, token, "");
            case 1 -> replace(text, token, token.group() + " " + token.group());
            case 2 -> swapped(text, token, pick(tokens));
            case 3 -> text.substring(0, random.nextInt(text.length() + 1));
            case 4, 5 -> line(text, true);
            case 6 -> line(text, false);
            case 7 -> insert(text, pick(ODD));
            case 8, 9 -> replace(text, token, token.group() + " " + pick(PIECES));
            case 10, 11 -> replaceOne(text, tokens, "[A-Z]\\w*|int|boolean|double|long", pick(TYPES));
            case 12, 13 -> replaceOne(text, tokens, "\\d.*|[a-z]\\w*", pick(NUMBERS));
            case 14, 15 -> replaceOne(text, tokens, "\\W.*", pick(OPERATORS));
            case 16 -> replaceOne(text, tokens, "\\w+", pick(NAME, pick(tokens(anyText()))));
            default -> replaceOne(text, tokens, "[A-Za-z_]\\w*", pick(NAME, pick(tokens)));
        };
    }

    /** A name for another, wherever it occurs: the models keep their meaning, or nearly. */
    private ModelSet renamedEverywhere(ModelSet set) {
        MatchResult token = pick(tokens(set.text(anyPath(set))));
        if (!NAME.matcher(token.group()).matches()) {
            return set;
        }
        Pattern old = Pattern.compile("\\b" + token.group() + "\\b");
        String fresh = Matcher.quoteReplacement(pick(JAVA_NAMES));
        ModelSet renamed = set;
        for (String path : set.files().keySet()) {
            String text = old.matcher(set.text(path)).replaceAll(fresh);
            String place = old.matcher(path).replaceAll(fresh);
            if (!place.equals(path)) {
                renamed = renamed.without(path);
            }
            if (!place.equals(path) || !text.equals(set.text(path))) {
                renamed = renamed.with(place, text);
            }
        }
        return renamed;
    }

    /** A line of whatever model, at the place of another one or beside it. */
    private String line(String text, boolean beside) {
        List<String> lines = new ArrayList<>(text.lines().toList());
        List<String> others = (random.nextBoolean() ? text : anyText()).lines().toList();
        int at = random.nextInt(lines.size());
        String other = others.isEmpty() ? "" : others.get(random.nextInt(others.size()));
        if (beside) {
            lines.add(at, other);
        } else {
            lines.set(at, other);
        }
        return String.join("\n", lines) + "\n";
    }

    private String insert(String text, String piece) {
        int at = random.nextInt(text.length() + 1);
        return text.substring(0, at) + piece + text.substring(at);
    }

    private String replaceOne(String text, List<MatchResult> tokens, String kind, String fresh) {
        List<MatchResult> fitting = tokens.stream().filter(t -> t.group().matches(kind)).toList();
        return fitting.isEmpty() ? text : replace(text, pick(fitting), fresh);
    }

    private static String swapped(String text, MatchResult one, MatchResult other) {
        MatchResult first = one.start() < other.start() ? one : other;
        MatchResult second = first == one ? other : one;
        return replace(replace(text, second, first.group()), first, second.group());
    }

    private static String replace(String text, MatchResult token, String fresh) {
        return text.substring(0, token.start()) + fresh + text.substring(token.end());
    }

    private static List<MatchResult> tokens(String text) {
        return TOKEN.matcher(text).results().toList();
    }

    private String anyText() {
        ModelSet donor = pick(donors);
        return donor.text(anyPath(donor));
    }

    private String anyPath(ModelSet set) {
        return pick(List.copyOf(set.files().keySet()));
    }

    /** A token where it is a name, else some name of Java's. */
    private String pick(Pattern kind, MatchResult token) {
        return kind.matcher(token.group()).matches() ? token.group() : pick(JAVA_NAMES);
    }

    private <T> T pick(List<T> from) {
        return from.get(random.nextInt(from.size()));
    }

    private String pick(String[] from) {
        return from[random.nextInt(from.length)];
    }
}
