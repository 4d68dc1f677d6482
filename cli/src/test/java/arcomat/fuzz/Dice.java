package arcomat.fuzz;

import java.util.List;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Draws places in texts and things to put there; the same seed draws the same. */
public final class Dice {
    /** Words that Java, generated code or its runtime use for something else. */
    private static final String[] TAKEN_NAMES = {
        "class",
        "String",
        "Main",
        "Object",
        "step",
        "this",
        "int_",
        "Integer",
        "state",
        "java",
        "arcomat",
        "rt",
        "run",
        "main",
        "System",
        "goto",
        "enum",
        "assert",
        "Math",
        "choice",
        "reset",
        "Boolean",
        "Check",
        "Choice",
        "ModelError",
        "INITIAL",
        "input",
        "output",
        "getClass",
        "wait",
        "hashCode",
        "notify",
        "toString",
        "void_",
        "_",
        "__",
        "$",
        "a$b",
        "x1",
        "X1",
        "equals",
        "const",
        "clear",
        "values",
        "valueOf",
        "ordinal",
        "name",
        "length",
        "Override",
        "slice",
        "taken",
        "sense",
        "enabled",
        "section0",
        "nextTotal",
        "SILENCE",
        "code",
        "of",
        "List",
        "Queue",
    };

    private static final Pattern TOKEN =
            Pattern.compile(
                    "//[^\n]*|/\\*.*?\\*/|\"[^\"\n]*\"|\\d+(?:\\.\\d+)?|\\w+|==|->|=>|--|&&|\\|\\||"
                            + "[<>!]=|\\.\\.|\\S",
                    Pattern.DOTALL);

    private final Random random;

    public Dice(long seed) {
        random = new Random(seed);
    }

    public int below(int bound) {
        return random.nextInt(bound);
    }

    public <T> T one(List<T> from) {
        return from.get(below(from.size()));
    }

    public String one(String... from) {
        return from[below(from.length)];
    }

    String path(ModelSet set) {
        return one(List.copyOf(set.files().keySet()));
    }

    static List<MatchResult> tokens(String text) {
        return TOKEN.matcher(text).results().toList();
    }

    static String replace(String text, MatchResult token, String fresh) {
        return text.substring(0, token.start()) + fresh + text.substring(token.end());
    }

    /** One of the tokens of a kind gives way to what is made of it. */
    String replaceOne(String text, String kind, java.util.function.UnaryOperator<String> fresh) {
        List<MatchResult> fitting =
                tokens(text).stream().filter(t -> t.group().matches(kind)).toList();
        if (fitting.isEmpty()) {
            return text;
        }
        MatchResult token = one(fitting);
        return replace(text, token, fresh.apply(token.group()));
    }

    /** A token of a kind, as the text has them; one that Java has taken if there is none. */
    String token(String text, String kind) {
        List<String> fitting =
                tokens(text).stream().map(MatchResult::group).filter(t -> t.matches(kind)).toList();
        return fitting.isEmpty() ? one(TAKEN_NAMES) : one(fitting);
    }

    /** A name for another, wherever it occurs: the models keep their meaning, or nearly. */
    ModelSet renamedEverywhere(ModelSet set) {
        String old = token(set.text(path(set)), "[A-Za-z_]\\w*");
        Pattern word = Pattern.compile("(?<![\\w$])" + Pattern.quote(old) + "(?![\\w$])");
        String fresh = Matcher.quoteReplacement(one(TAKEN_NAMES));
        ModelSet renamed = set;
        for (String path : set.files().keySet()) {
            String text = word.matcher(set.text(path)).replaceAll(fresh);
            String place = word.matcher(path).replaceAll(fresh);
            if (!place.equals(path)) {
                renamed = renamed.without(path);
            }
            if (!place.equals(path) || !text.equals(set.text(path))) {
                renamed = renamed.with(place, text);
            }
        }
        return renamed;
    }
}
