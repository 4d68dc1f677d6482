package arcomat.laws.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** An arbitrary automaton as text, each element on a line of its own. */
final class AutomatonText {
    private record Local(String name, String type) {}

    private final Draw draw;
    private final boolean events;
    private final List<Plug> inputs;
    private final List<Plug> outputs;
    private final List<Local> locals = new ArrayList<>();
    private final List<String> lines = new ArrayList<>();
    private final boolean free;
    private final boolean ranked;

    private AutomatonText(Draw draw, List<Plug> plugs, boolean events) {
        this.draw = draw;
        this.events = events;
        this.inputs = Plug.inputs(plugs);
        this.outputs = Plug.outputs(plugs);
        this.free = draw.chance(Features.OPEN, 15);
        this.ranked = draw.chance(Features.RANKS, 15);
    }

    /**
     * @param plugs of the component that the automaton may read and write
     */
    static List<String> of(Draw draw, List<Plug> plugs, boolean events, String name) {
        AutomatonText text = new AutomatonText(draw, plugs, events);
        if (name.isEmpty() && TableText.canBe(plugs) && draw.chance(Features.TABLES, 15)) {
            return new TableText(draw, plugs, events, text::message).write(text.head());
        }
        boolean computed = name.isEmpty() && !events && draw.chance(Features.COMPUTED, 15);
        return computed ? text.compute() : text.write(name);
    }

    /** A table instead. */
    static List<String> table(Draw draw, List<Plug> plugs) {
        AutomatonText text = new AutomatonText(draw, plugs, false);
        return new TableText(draw, plugs, false, text::message).write(text.head());
    }

    private List<String> write(String name) {
        lines.add("    %s automaton%s {".formatted(head(), name.isEmpty() ? "" : " " + name));
        variables(name.isEmpty() && draw.chance(Features.FIELDS, 30));
        int states = draw.chance(10) ? 1 + draw.below(12) : 1 + draw.below(4);
        IntStream.range(0, states).forEach(i -> lines.add("        state s%d;".formatted(i)));
        initial(0);
        if (states > 1 && draw.chance(20)) {
            initial(1 + draw.below(states - 1));
        }
        for (int state = 0; state < states; state++) {
            for (int count = draw.below(4); count > 0; count--) {
                transition(state, draw.below(states));
            }
        }
        lines.add("    }");
        return lines;
    }

    private String head() {
        String omitted = free ? ", omitted = \"free\"" : "";
        return "<<completion = \"%s\"%s>>".formatted(completion(), omitted);
    }

    /** What is read without being asked for may be missing. */
    private List<String> compute() {
        lines.add("    %s compute {".formatted(head()));
        variables(true);
        List<Plug> present = new ArrayList<>();
        inputs.stream().filter(each -> each.total() || draw.chance(50)).forEach(present::add);
        lines.add("        " + statements(effects(present), present));
        lines.add("    }");
        List<String> first = initially();
        if (!first.isEmpty()) {
            lines.add("    init { %s; }".formatted(String.join("; ", first)));
        }
        return lines;
    }

    private String completion() {
        boolean total = outputs.stream().anyMatch(Plug::total);
        List<String> possible = new ArrayList<>();
        if (draw.has(Features.OPEN)) {
            possible.addAll(List.of("chaos", "output"));
        }
        if (!total) {
            possible.addAll(List.of("ignore", "ignore"));
        }
        if (draw.has(Features.ERRORS) || possible.isEmpty()) {
            possible.add("error");
        }
        return draw.one(possible);
    }

    /**
     * @param beside whether they stand in the component
     */
    private void variables(boolean beside) {
        if (draw.chance(35)) {
            String type = draw.one("Boolean", "Integer[0..2]", "Integer[0..2]", "Integer[-1..3]");
            if (draw.chance(Features.UNBOUNDED, 15)) {
                type = draw.one("Integer", "String");
            }
            if (draw.chance(Features.NUMBER_TYPES, 15)) {
                type = draw.one("byte", "short", "char", "char", "Long", "float");
            }
            String first = type.equals("Integer[-1..3]") ? "-1" : draw.one(Plug.messages(type));
            String size = draw.chance(Features.ARRAYS, 20) ? "[2]" : "";
            List<String> names = size.isEmpty() ? List.of("n") : List.of("n[0]", "n[1]");
            for (String name : names) {
                locals.add(new Local(name, type));
            }
            if (beside) {
                lines.add(0, "    var %s n%s = %s;".formatted(type, size, first));
            } else {
                lines.add("        variable %s n%s = %s;".formatted(type, size, first));
            }
        }
    }

    private void initial(int state) {
        lines.add("        initial s%d%s;".formatted(state, block(" / ", initially())));
    }

    private List<String> initially() {
        List<String> effects = new ArrayList<>();
        for (Plug output : outputs) {
            boolean sends = events ? draw.chance(25) : output.delay() == 1 && draw.chance(50);
            if (sends || output.total() && output.delay() == 1) {
                effects.add(output.name() + " = " + draw.one(Plug.messages(output.type())));
            }
        }
        return effects;
    }

    private static String block(String before, List<String> items) {
        return items.isEmpty() ? "" : before + "{" + String.join(", ", items) + "}";
    }

    private void transition(int source, int target) {
        List<Plug> present = new ArrayList<>();
        List<String> items = events ? List.of(event(present)) : items(present);
        String guard = draw.chance(30) ? guard(present) : "";
        List<String> effects = effects(present);
        lines.add(
                "        %ss%d -> s%d%s%s%s;"
                        .formatted(
                                ranked ? Ranks.text(draw.below(3)) : "",
                                source,
                                target,
                                guard.isEmpty() ? "" : " [" + guard + "]",
                                block(" ", items),
                                draw.chance(Features.STATEMENTS, 20)
                                        ? " / do { " + statements(effects, present) + " }"
                                        : block(" / ", effects)));
    }

    private List<String> effects(List<Plug> present) {
        List<String> effects = new ArrayList<>();
        for (Plug output : outputs) {
            if (output.total() || draw.chance(60)) {
                effects.add(sends(output, present));
            }
        }
        for (Local local : locals) {
            if (draw.chance(40)) {
                effects.add(keeps(local, present));
            }
        }
        return effects;
    }

    private String sends(Plug output, List<Plug> present) {
        return output.name() + " = " + sent(output, present);
    }

    private String keeps(Local local, List<Plug> present) {
        return local.name + " = " + value(local.type, present);
    }

    /** The effects, and then choices of others: whatever is sent in every slice is sent. */
    private String statements(List<String> effects, List<Plug> present) {
        StringBuilder text = new StringBuilder();
        effects.forEach(each -> text.append(each).append("; "));
        for (int count = draw.below(3); count > 0; count--) {
            text.append("if (").append(guard(present)).append(") { ");
            text.append(statement(present)).append(" }");
            text.append(draw.chance(50) ? " else { " + statement(present) + " } " : " ");
        }
        return text.append(draw.chance(40) ? statement(present) : "").toString().strip();
    }

    private String statement(List<Plug> present) {
        if (!locals.isEmpty() && draw.chance(60)) {
            return keeps(locals.get(0), present) + ";";
        }
        if (outputs.isEmpty()) {
            return "{ }";
        }
        Plug output = draw.one(outputs);
        if (draw.chance(70)) {
            return sends(output, present) + ";";
        }
        String type = output.type().startsWith("Integer") ? "Integer" : output.type();
        return "{ var %s k = %s; %s = k; }"
                .formatted(type, value(output.type(), present), output.name());
    }

    private String event(List<Plug> present) {
        Plug plug = draw.one(inputs.stream().filter(input -> !input.latched()).toList());
        present.add(plug);
        return item(plug, draw.below(5));
    }

    private List<String> items(List<Plug> present) {
        List<String> items = new ArrayList<>();
        for (Plug input : inputs) {
            if (draw.chance(20) && !input.total()) {
                items.add(input.name() + " == --");
            } else if (draw.chance(60)) {
                present.add(input);
                items.add(item(input, draw.below(5)));
            } else if (input.total()) {
                present.add(input);
            }
        }
        return items;
    }

    private String item(Plug plug, int kind) {
        List<String> messages = Plug.messages(plug.type());
        String asked =
                switch (kind) {
                    case 0 -> "?";
                    case 1 -> "alt {" + draw.one(messages) + ", " + draw.one(messages) + "}";
                    default -> draw.one(messages);
                };
        return plug.name() + " == " + asked;
    }

    private String guard(List<Plug> present) {
        if (draw.chance(Features.QUANTIFIERS, 10)) {
            return quantified(present);
        }
        if (draw.chance(Features.ERRORS, 25)) {
            return nested(present, 1 + draw.below(2));
        }
        String atom = atom(present);
        return switch (draw.below(6)) {
            case 0 -> "!(" + atom + ")";
            case 1 -> atom + " || " + atom(present);
            case 2 -> atom + " && " + atom(present);
            case 3 -> draw.chance(50) ? atom + " implies " + atom(present) : atom;
            default -> atom;
        };
    }

    /** Parts that may go wrong, with others on both sides that keep them from it, or do not. */
    private String nested(List<Plug> present, int depth) {
        if (depth == 0) {
            return risky(present);
        }
        String left = nested(present, depth - 1);
        String right = nested(present, draw.below(depth));
        return switch (draw.below(8)) {
            case 0 -> "!(" + left + ")";
            case 1, 2 -> "(" + left + " || " + right + ")";
            case 3 -> "(" + left + " implies " + right + ")";
            case 4 -> "(" + risky(present) + " ? " + left + " : " + right + ")";
            default -> "(" + left + " && " + right + " && " + risky(present) + ")";
        };
    }

    /** Divides, cuts off, or is any other part. */
    private String risky(List<Plug> present) {
        List<String> numbers = new ArrayList<>();
        readable(present).stream()
                .filter(plug -> Plug.isCalculated(plug.type()))
                .forEach(plug -> numbers.add(plug.name()));
        locals.stream()
                .filter(local -> Plug.isCalculated(local.type))
                .forEach(local -> numbers.add(local.name));
        if (numbers.isEmpty() || draw.chance(50)) {
            return atom(present);
        }
        String number = draw.one(numbers);
        return draw.one("6 % %s == 1", "2 / %s > 1", "%s != 6 / %s", "(byte) (%s * 127) < %s")
                .replace("%s", number);
    }

    /** About a value that has another name, or about each of some values. */
    private String quantified(List<Plug> present) {
        Plug plug = draw.one(readable(present));
        String type = plug.type();
        String not = draw.one("==", "!=");
        if (Plug.isWhole(type)) {
            String domain = draw.one("{0, 2}", "{0..2}", "Set {0..1, 2}");
            return draw.chance(50)
                    ? "(forall v in %s: %s %s v || %s)"
                            .formatted(domain, plug.name(), not, atom(present))
                    : "(exists v in %s: %s %s v && v < 2)".formatted(domain, plug.name(), not);
        }
        if (locals.size() > 1 && draw.chance(50)) {
            return "(forall v in n: %s)".formatted(compared("v", locals.get(0).type, "v"));
        }
        return type.equals("Boolean")
                ? "(exists v in Boolean: %s %s v)".formatted(plug.name(), not)
                : "(let v = %s in v %s v)".formatted(plug.name(), not);
    }

    private List<Plug> readable(List<Plug> present) {
        return events
                ? inputs.stream().filter(p -> p.latched() || present.contains(p)).toList()
                : inputs;
    }

    private String atom(List<Plug> present) {
        if (!locals.isEmpty() && draw.chance(50)) {
            Local local = locals.get(0);
            return compared(local.name, local.type, draw.one(values(local.type)));
        }
        Plug plug = draw.one(readable(present));
        if (!events && !plug.total() && draw.chance(20)) {
            return plug.name() + draw.one(" == --", " != --");
        }
        return compared(plug.name(), plug.type(), draw.one(values(plug.type())));
    }

    private String compared(String left, String type, String right) {
        String operator =
                Plug.isNumber(type)
                        ? draw.one("<", "<=", ">", ">=", "==", "!=")
                        : draw.one("==", "!=");
        boolean calculated = Plug.isWhole(type) && draw.chance(15);
        if (calculated && draw.chance(30)) {
            return left + " + 1 < " + left;
        }
        return left + (calculated ? draw.one(" + 1", " - 1") : "") + " " + operator + " " + right;
    }

    private static List<String> values(String type) {
        return Plug.messages(type.startsWith("Integer[") ? "Integer[0..2]" : type);
    }

    private String sent(Plug output, List<Plug> present) {
        String first = message(output, present);
        return events && !first.equals("--") && draw.chance(20)
                ? "[" + first + ", " + value(output.type(), present) + "]"
                : first;
    }

    /** One message, or none. */
    private String message(Plug output, List<Plug> present) {
        if (!events && draw.chance(Features.OPEN, 8)) {
            return "?";
        }
        if (!output.total() && draw.chance(8)) {
            return "--";
        }
        return value(output.type(), present);
    }

    /** A value to send or to keep: a constant, a message, a variable, or calculated. */
    private String value(String type, List<Plug> present) {
        List<String> sources = new ArrayList<>();
        present.stream().filter(p -> p.type().equals(type)).forEach(p -> sources.add(p.name()));
        locals.stream().filter(l -> l.type.equals(type)).forEach(l -> sources.add(l.name));
        if (sources.isEmpty() || draw.chance(50)) {
            return draw.one(values(type));
        }
        String source = draw.one(sources);
        if (Plug.isWhole(type) && draw.chance(Features.ERRORS, 25)) {
            return Plug.calculated(
                    type, draw.chance(20) ? "2 / " + source : source + draw.one(" + 1", " - 1"));
        }
        return source;
    }
}
