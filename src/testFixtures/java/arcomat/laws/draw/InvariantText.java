package arcomat.laws.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** An arbitrary invariant as text, about ports and the variable that an automaton may have. */
public final class InvariantText {
    private static final Pattern VARIABLE = Pattern.compile("variable (\\S+) n ");

    private final Draw draw;
    private final List<Plug> ports;
    private final List<Plug> values;

    private InvariantText(Draw draw, List<Plug> ports, List<Plug> values) {
        this.draw = draw;
        this.ports = ports;
        this.values = values;
    }

    /**
     * @param component its text, to see which variable it has
     */
    public static String of(Draw draw, List<Plug> ports, String component) {
        List<Plug> values = new ArrayList<>(ports);
        Matcher variable = VARIABLE.matcher(component);
        if (variable.find() && !variable.find()) {
            variable.find(0);
            Plug local = Plug.in("n", variable.group(1), true);
            values.addAll(List.of(local, local));
            if (draw.chance(15)) {
                return new InvariantText(draw, List.of(), List.of(local)).condition(1);
            }
        }
        return new InvariantText(draw, ports, values).condition(2);
    }

    private String condition(int depth) {
        if (depth == 0 || draw.chance(20)) {
            return atom();
        }
        String left = condition(depth - 1);
        String right = condition(depth - 1);
        return switch (draw.below(5)) {
            case 0 -> "(" + left + ") && (" + right + ")";
            case 1 -> "(" + left + ") implies (" + right + ")";
            case 2 -> "!(" + left + ")";
            default -> "(" + left + ") || (" + right + ")";
        };
    }

    private String atom() {
        if (!ports.isEmpty() && draw.chance(35)) {
            return draw.one(ports).name() + draw.one(" == --", " != --");
        }
        Plug value = draw.one(values);
        List<Plug> others =
                values.stream().filter(p -> p != value && p.type().equals(value.type())).toList();
        boolean small = value.type().startsWith("Integer[");
        if (small && draw.chance(8)) {
            return "2 / " + value.name() + draw.one(" > 1", " == 0", " < 2");
        }
        String right =
                others.isEmpty() || draw.chance(60)
                        ? draw.one(Plug.messages(small ? "Integer[0..2]" : value.type()))
                        : draw.one(others).name();
        String operator =
                value.isNumber() ? draw.one("<", "<=", ">=", "==", "!=") : draw.one("==", "!=");
        String left = small && draw.chance(10) ? value.name() + " + 1" : value.name();
        return left + " " + operator + " " + right;
    }
}
