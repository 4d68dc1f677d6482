package arcomat.laws.naive;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Components with features, written out by hand for each configuration: the lines that stand where
 * a condition is true. Knows random models only, in which each {@code varif} has a line of its own
 * and conditions have brackets around whatever is connected.
 */
public final class ByHand {
    private static final Pattern FEATURES = Pattern.compile("\\s*feature (.*);");
    private static final Pattern CONSTRAINT = Pattern.compile("\\s*constraint (.*);");
    private static final Pattern BEGIN = Pattern.compile("(?:.*\\}\\s*else )?\\s*varif (.*) \\{");
    private static final Pattern NAMED = Pattern.compile("\\bwith\\.(\\w+)\\((.*)\\)(?= |$)");

    private final List<SourceFile> files;

    /**
     * @param files components with features lie in the package {@code with}
     */
    public ByHand(List<SourceFile> files) {
        this.files = List.copyOf(files);
    }

    /**
     * A configuration of a component, and what has been written in its place.
     *
     * @param name of the configuration
     * @param written the name of the component that is its equal
     */
    public record Pair(String name, String written, Map<String, Boolean> choices) {}

    /** All configurations of components with features, in the order of the files. */
    public List<Pair> pairs() {
        return files.stream().filter(ByHand::hasFeatures).flatMap(ByHand::pairs).toList();
    }

    public static boolean hasFeatures(SourceFile file) {
        return file.text().lines().anyMatch(FEATURES.asMatchPredicate());
    }

    private static Stream<Pair> pairs(SourceFile file) {
        return configurations(file.text().lines().toList()).stream()
                .map(
                        choices ->
                                new Pair(
                                        "with." + simpleName(file) + text(choices),
                                        written(simpleName(file), choices),
                                        choices));
    }

    private static String simpleName(SourceFile file) {
        return file.path().replaceAll(".*/|\\.arc", "");
    }

    private static String text(Map<String, Boolean> choices) {
        List<String> texts = new ArrayList<>();
        choices.forEach((feature, choice) -> texts.add(feature + " = " + choice));
        return "(" + String.join(", ", texts) + ")";
    }

    /** {@code hand.Main_g_true}. */
    private static String written(String simpleName, Map<String, Boolean> choices) {
        StringBuilder name = new StringBuilder("hand.").append(simpleName);
        choices.forEach(
                (feature, choice) -> name.append('_').append(feature).append('_').append(choice));
        return name.toString();
    }

    /** The choices that keep all constraints. */
    public static List<Map<String, Boolean>> configurations(List<String> lines) {
        List<Map<String, Boolean>> all = List.of(Map.of());
        for (String feature : features(lines)) {
            all =
                    all.stream()
                            .flatMap(
                                    one ->
                                            Stream.of(
                                                    with(one, feature, true),
                                                    with(one, feature, false)))
                            .toList();
        }
        List<String> constraints =
                lines.stream()
                        .map(CONSTRAINT::matcher)
                        .filter(Matcher::matches)
                        .map(m -> m.group(1))
                        .toList();
        return all.stream()
                .filter(one -> constraints.stream().allMatch(each -> isTrue(each, one)))
                .toList();
    }

    private static Map<String, Boolean> with(
            Map<String, Boolean> some, String feature, boolean choice) {
        Map<String, Boolean> more = new LinkedHashMap<>(some);
        more.put(feature, choice);
        return more;
    }

    private static List<String> features(List<String> lines) {
        return lines.stream()
                .map(FEATURES::matcher)
                .filter(Matcher::matches)
                .flatMap(found -> Stream.of(found.group(1).split(", ")))
                .toList();
    }

    /** What conditions choose, by the names of the features that they are for. */
    public static Map<String, Boolean> choices(
            Map<String, String> conditions, Map<String, Boolean> around) {
        Map<String, Boolean> choices = new LinkedHashMap<>();
        conditions.forEach((feature, each) -> choices.put(feature, isTrue(each, around)));
        return choices;
    }

    /** The same models without features; each configuration is a component of its own. */
    public List<SourceFile> written() {
        List<SourceFile> all = new ArrayList<>();
        for (SourceFile file : files) {
            if (hasFeatures(file)) {
                pairs(file).forEach(each -> all.add(written(file, each)));
            } else {
                all.add(new SourceFile(file.path(), renamed(file.text(), Map.of())));
            }
        }
        return all;
    }

    private SourceFile written(SourceFile file, Pair equal) {
        String simple = equal.written().substring("hand.".length());
        StringBuilder text = new StringBuilder();
        for (String line : chosen(file.text().lines().toList(), equal.choices())) {
            text.append(line).append('\n');
        }
        String own =
                text.toString()
                        .replaceFirst("package with;", "package hand;")
                        .replaceFirst(
                                "component " + simpleName(file) + "\\b", "component " + simple);
        return new SourceFile("hand/" + simple + ".arc", renamed(own, equal.choices()));
    }

    /** Whose features are chosen here is the component that was written for the choice. */
    private String renamed(String text, Map<String, Boolean> around) {
        return text.lines()
                .map(
                        line ->
                                NAMED.matcher(line)
                                        .replaceAll(
                                                found ->
                                                        Matcher.quoteReplacement(
                                                                name(found, around))))
                .reduce("", (all, line) -> all + line + "\n");
    }

    private String name(MatchResult found, Map<String, Boolean> around) {
        SourceFile named =
                files.stream()
                        .filter(each -> each.path().equals("with/" + found.group(1) + ".arc"))
                        .findFirst()
                        .orElseThrow();
        List<String> others = new ArrayList<>(List.of(found.group(2).split(", ")));
        Map<String, Boolean> choices = new LinkedHashMap<>();
        for (String feature : features(named.text().lines().toList())) {
            Optional<String> argument =
                    others.stream().filter(each -> each.startsWith(feature + " = ")).findFirst();
            others.remove(argument.orElseThrow());
            choices.put(feature, isTrue(argument.get().substring(feature.length() + 3), around));
        }
        others.remove("");
        return written(simpleName(named), choices)
                + (others.isEmpty() ? "" : "(" + String.join(", ", others) + ")");
    }

    private static List<String> chosen(List<String> lines, Map<String, Boolean> choices) {
        List<String> left = new ArrayList<>();
        chosen(lines, 0, true, choices, left);
        return left;
    }

    /** Reads to the end of a block; returns the line that ends it. */
    private static int chosen(
            List<String> lines,
            int from,
            boolean taken,
            Map<String, Boolean> choices,
            List<String> left) {
        int depth = 0;
        for (int i = from; i < lines.size(); i++) {
            String line = lines.get(i);
            Matcher begin = BEGIN.matcher(line);
            if (depth == 0 && line.strip().startsWith("}")) {
                return i;
            } else if (line.strip().startsWith("varif ") && begin.matches()) {
                i = variation(lines, i, taken, choices, left);
            } else if (!FEATURES.matcher(line).matches() && !CONSTRAINT.matcher(line).matches()) {
                depth += nesting(line);
                if (taken) {
                    left.add(line);
                }
            }
        }
        return lines.size();
    }

    /** Of one side after the other the first that is true; returns the line of the last brace. */
    private static int variation(
            List<String> lines,
            int from,
            boolean taken,
            Map<String, Boolean> choices,
            List<String> left) {
        boolean open = taken;
        int at = from;
        do {
            Matcher begin = BEGIN.matcher(lines.get(at));
            boolean here = open && (!begin.matches() || isTrue(begin.group(1), choices));
            at = chosen(lines, at + 1, here, choices, left);
            open &= !here;
        } while (at < lines.size() && lines.get(at).contains("} else "));
        return at;
    }

    /** How many braces a line leaves open. */
    public static int nesting(String line) {
        return (int)
                (line.chars().filter(c -> c == '{').count()
                        - line.chars().filter(c -> c == '}').count());
    }

    /** Of {@code true}, {@code f}, {@code !X}, {@code (X)} and {@code (X && Y)} with others. */
    static boolean isTrue(String condition, Map<String, Boolean> choices) {
        String text = condition.strip();
        if (text.startsWith("!")) {
            return !isTrue(text.substring(1), choices);
        }
        if (!text.startsWith("(")) {
            return text.equals("true") || !text.equals("false") && choices.get(text);
        }
        String inner = text.substring(1, text.length() - 1);
        for (Map.Entry<String, Connective> each : CONNECTIVES.entrySet()) {
            int at = outside(inner, " " + each.getKey() + " ");
            if (at >= 0) {
                String right = inner.substring(at + each.getKey().length() + 2);
                return each.getValue()
                        .of(isTrue(inner.substring(0, at), choices), isTrue(right, choices));
            }
        }
        return isTrue(inner, choices);
    }

    private interface Connective {
        boolean of(boolean left, boolean right);
    }

    private static final Map<String, Connective> CONNECTIVES =
            Map.of(
                    "&&", (a, b) -> a && b,
                    "||", (a, b) -> a || b,
                    "implies", (a, b) -> !a || b,
                    "==", (a, b) -> a == b,
                    "!=", (a, b) -> a != b);

    /** Where something stands outside of all brackets. */
    private static int outside(String text, String sought) {
        int depth = 0;
        for (int i = 0; i < text.length(); i++) {
            depth += text.charAt(i) == '(' ? 1 : text.charAt(i) == ')' ? -1 : 0;
            if (depth == 0 && text.startsWith(sought, i)) {
                return i;
            }
        }
        return -1;
    }
}
