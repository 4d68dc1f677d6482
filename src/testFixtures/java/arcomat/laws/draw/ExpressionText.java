package arcomat.laws.draw;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * An arbitrary expression of the whole grammar as text, in one of the places where an automaton may
 * have one. All ports that it may read exist in one component, each of them may be silent, and one
 * of each type is total.
 */
public final class ExpressionText {
    private static final List<String> WHOLE = List.of("Integer", "small", "byte", "short", "char");
    private static final List<String> NUMBERS =
            Stream.concat(WHOLE.stream(), Stream.of("Long", "float", "Double")).toList();
    private static final String ENUM = "t.Types.E";
    private static final String OBJECT = "t.Things.Reading";
    private static final List<String> OTHERS = List.of("Boolean", "String", ENUM, OBJECT);

    /** What an object has, by type. */
    private static final Map<String, String> ATTRIBUTES =
            Map.of("Integer", "value", "Boolean", "valid", "Double", "heat", "String", "by");

    /** What texts write as values, beside those that ports are drawn with. */
    private static final Map<String, List<String>> CONSTANTS =
            Map.of(
                    "small", List.of("0", "1", "2", "6 - 5"),
                    "Integer", List.of("0", "1", "-1", "2147483647", "-2147483648"),
                    "Double", List.of("0.0", "-0.0", "0.5", "1.0e300"),
                    "float", List.of("0.0f", "-0.0f", "1.5f"));

    /** Each port that may be silent doubles the letters that an analysis looks at. */
    private static final int MOST_PORTS = 4;

    private final Draw draw;
    private final Set<String> ports = new LinkedHashSet<>();

    /** The names that quantifiers around a place bind, with their types. */
    private final Map<String, String> given = new LinkedHashMap<>();

    private ExpressionText(Draw draw) {
        this.draw = draw;
    }

    /** The types that the component knows, and the component with an expression. */
    public static List<SourceFile> models(Draw draw) {
        SourceFile things =
                new SourceFile(
                        "t/Things.cd",
                        """
                        package t;
                        classdiagram Things {
                            class Reading { Integer value; Boolean valid; Double heat; String by; }
                        }
                        """);
        return List.of(ComponentText.types(), things, new ExpressionText(draw).component());
    }

    private SourceFile component() {
        String behaviour = String.join("\n", behaviour());
        List<String> lines = new ArrayList<>(List.of("package a;", "component Main {"));
        lines.add("    timing instant;");
        for (String type : Stream.concat(NUMBERS.stream(), OTHERS.stream()).toList()) {
            for (int i = 0; i < 3; i++) {
                if (ports.contains(port(type, i))) {
                    String total = i == 2 ? "<<total>> " : "";
                    lines.add(
                            "    port %sin %s %s;".formatted(total, written(type), port(type, i)));
                }
            }
        }
        lines.add(behaviour);
        lines.add("}");
        return new SourceFile("a/Main.arc", String.join("\n", lines) + "\n");
    }

    private static String port(String type, int number) {
        return type.replaceAll(".*\\.", "").toLowerCase(Locale.ROOT) + "In" + number;
    }

    private static String written(String type) {
        return type.equals("small") ? "Integer[0..2]" : type;
    }

    private List<String> behaviour() {
        String type = draw.one("Boolean", "Boolean", "Integer", "Long", "Double", "String");
        String truth = truth(1 + draw.below(4));
        String value = value(type, 1 + draw.below(3));
        String step =
                switch (draw.below(6)) {
                    case 0 -> "s / {u = %s};".formatted(value);
                    case 1 -> "s [%s] / {u = %s};".formatted(truth, value);
                    case 2 -> "s / do { if (%s) { u = %s; } }".formatted(truth, value);
                    case 3 -> "s [k == k] / {k = %s};".formatted(value);
                    default -> "s [%s] / {u = k};".formatted(truth);
                };
        return List.of(
                "    port out %s u;".formatted(type),
                "    <<completion = \"ignore\">> automaton {",
                "        state s;",
                "        initial s;",
                "        variable %s k = %s;".formatted(type, constant(type)),
                "        " + step,
                "    }");
    }

    private String constant(String type) {
        return draw.one(CONSTANTS.getOrDefault(type, Plug.messages(written(type))));
    }

    private String leaf(String type) {
        List<String> bound =
                given.keySet().stream().filter(name -> type.equals(given.get(name))).toList();
        if (!bound.isEmpty() && draw.chance(40)) {
            return draw.one(bound);
        }
        if (ATTRIBUTES.containsKey(type) && draw.chance(10)) {
            return object() + "." + ATTRIBUTES.get(type);
        }
        if (type.equals(OBJECT)) {
            return object();
        }
        return draw.chance(30) ? constant(type) : read(type, draw.below(3)).orElse(constant(type));
    }

    /** Models make no objects: there is always a port to take one from. */
    private String object() {
        String port = port(OBJECT, draw.below(3));
        ports.add(port);
        return port;
    }

    /** That port, or another one of its type where there are enough. */
    private Optional<String> read(String type, int number) {
        if (ports.size() < MOST_PORTS) {
            ports.add(port(type, number));
        }
        return Stream.of(number, 0, 1, 2)
                .map(each -> port(type, each))
                .filter(ports::contains)
                .findFirst();
    }

    private String value(String type, int depth) {
        if (type.equals("Boolean")) {
            return truth(depth);
        }
        if (depth == 0) {
            return leaf(type);
        }
        if (draw.chance(30)) {
            return choice(type, depth - 1);
        }
        if (NUMBERS.contains(type)) {
            return number(type, depth - 1);
        }
        return type.equals("String")
                ? "(%s + %s)".formatted(value(type, depth - 1), value(type, depth - 1))
                : leaf(type);
    }

    private String choice(String type, int depth) {
        String form = draw.chance(80) ? "(%s ? %s : %s)" : "(if %s then %s else %s)";
        return form.formatted(truth(depth), value(type, depth), value(type, depth));
    }

    /** What is calculated in one type and needed in another one is cast. */
    private String number(String type, int depth) {
        boolean whole = WHOLE.contains(type) || type.equals("Long");
        String text =
                switch (draw.below(6)) {
                    case 0 -> "-" + leaf(type);
                    case 1 -> (whole ? "~" : "+") + "(" + value(type, depth) + ")";
                    case 2 -> "(" + value(draw.one(NUMBERS), depth) + ")";
                    default ->
                            "(%s %s %s)"
                                    .formatted(
                                            value(type, depth),
                                            draw.one("+", "-", "*", "/", "%"),
                                            value(draw.chance(80) ? type : "byte", depth));
                };
        return "(%s) %s".formatted(cast(type), text.startsWith("(") ? text : "(" + text + ")");
    }

    private static String cast(String type) {
        return switch (type) {
            case "Integer", "small" -> "int";
            case "Long" -> "long";
            case "Double" -> "double";
            default -> type;
        };
    }

    private String truth(int depth) {
        if (depth == 0) {
            return draw.chance(30) ? absence() : leaf("Boolean");
        }
        int less = depth - 1;
        return switch (draw.below(11)) {
            case 0 -> "!(" + truth(less) + ")";
            case 1, 2 ->
                    "(%s %s %s)"
                            .formatted(
                                    truth(less),
                                    draw.one("&&", "||", "implies", "<=>", "==", "!="),
                                    truth(less));
            case 3 -> choice("Boolean", less);
            case 4 -> member(less);
            case 5 -> quantified(less);
            case 6 -> compared(draw.one(OTHERS), List.of("==", "!="), less);
            default -> compared(draw.one(NUMBERS), List.of("<", "<=", ">", ">=", "==", "!="), less);
        };
    }

    private String absence() {
        String type = draw.one(draw.one(NUMBERS, OTHERS));
        return read(type, draw.below(2))
                .filter(port -> !port.endsWith("2"))
                .map(port -> port + draw.one(" == --", " != --"))
                .orElse("true");
    }

    private String compared(String type, List<String> operators, int depth) {
        return "(%s %s %s)".formatted(value(type, depth), draw.one(operators), value(type, depth));
    }

    private String member(int depth) {
        String type = draw.one(draw.one(NUMBERS, OTHERS));
        String set =
                Stream.generate(() -> value(type, depth / 2))
                        .limit(1 + draw.below(2))
                        .collect(Collectors.joining(", "));
        return "(%s isin {%s})".formatted(value(type, depth), set);
    }

    private String quantified(int depth) {
        String name = "v" + given.size();
        String type = draw.one("Integer", "Integer", ENUM, "Boolean", "Double");
        boolean let = draw.chance(40) || type.equals("Double");
        String head =
                let
                        ? "let %s = %s in ".formatted(name, value(type, depth))
                        : "%s %s in %s: "
                                .formatted(draw.one("forall", "exists"), name, domain(type));
        given.put(name, type);
        String text = "(" + head + truth(depth) + ")";
        given.remove(name);
        return text;
    }

    private String domain(String type) {
        return switch (type) {
            case "Integer" ->
                    draw.one("{0..2}", "{-1, 3}", "{0, 2..3, 2147483647}", "Integer[0..2]");
            case "Boolean" -> draw.one("Boolean", "{true}");
            default -> draw.one(ENUM, "{%1$s.k, %1$s.m}".formatted(ENUM));
        };
    }
}
