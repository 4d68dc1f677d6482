package arcomat.laws.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A port as it is written.
 *
 * @param delay of an output in slices
 * @param latched event-driven: keeps a value and triggers nothing
 */
public record Plug(
        String name, boolean input, String type, boolean total, int delay, boolean latched) {

    private static final Set<String> UNRANGED =
            Set.of("Double", "float", "byte", "short", "char", "Long");

    /** Types in which nothing is calculated. */
    private static final Set<String> CAST = Set.of("byte", "short", "char");

    static Plug in(String name, String type, boolean total) {
        return new Plug(name, true, type, total, 0, false);
    }

    static Plug out(String name, String type, boolean total, int delay) {
        return new Plug(name, false, type, total, delay, false);
    }

    Plug withDelay(int other) {
        return new Plug(name, input, type, total, other, latched);
    }

    Plug withTotal(boolean other) {
        return new Plug(name, input, type, other, delay, latched);
    }

    String line() {
        List<String> marks = new ArrayList<>();
        if (total) {
            marks.add("total");
        }
        if (!input && delay == 0) {
            marks.add("delay = \"0\"");
        }
        if (latched) {
            marks.add("state");
        }
        String stereotype = marks.isEmpty() ? "" : "<<" + String.join(", ", marks) + ">> ";
        return "    port " + stereotype + (input ? "in " : "out ") + type + " " + name + ";";
    }

    public static List<Plug> inputs(List<Plug> plugs) {
        return plugs.stream().filter(Plug::input).toList();
    }

    public static List<Plug> outputs(List<Plug> plugs) {
        return plugs.stream().filter(plug -> !plug.input).toList();
    }

    /** What a text writes as a message of a type. */
    static List<String> messages(String type) {
        return switch (type) {
            case "Boolean" -> List.of("true", "false");
            case "t.Types.E" -> List.of("k", "l", "m");
            case "Integer[0..2]" -> List.of("0", "1", "2");
            case "Integer" -> List.of("0", "1", "2", "-1");
            case "String" -> List.of("\"\"", "\"a\"", "\"b\"");
            case "Double" -> List.of("0.0", "0.5", "1.5");
            case "float" -> List.of("0.0f", "0.5f", "1.5f");
            case "byte" -> List.of("0", "1", "127", "-128");
            case "short" -> List.of("0", "1", "32767");
            case "char" -> List.of("'a'", "'b'", "98", "'\\u0000'");
            case "Long" -> List.of("0", "1L", "4294967297L", "-1");
            default -> throw new IllegalArgumentException(type);
        };
    }

    boolean isNumber() {
        return isNumber(type);
    }

    static boolean isNumber(String type) {
        return type.startsWith("Integer") || UNRANGED.contains(type);
    }

    /** What is calculated is of the type, cut off where Java does so and the text says it. */
    static String calculated(String type, String value) {
        return CAST.contains(type) ? "(" + type + ") (" + value + ")" : value;
    }

    /** Whether a value with 1 more may be written as one of the type. */
    static boolean isWhole(String type) {
        return type.startsWith("Integer") || type.equals("Long") || CAST.contains(type);
    }

    /** Whether it can stand wherever a number is calculated with. */
    static boolean isCalculated(String type) {
        return isWhole(type) && !type.equals("char");
    }
}
