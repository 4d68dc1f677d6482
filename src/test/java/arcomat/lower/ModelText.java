package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Letter;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** Writes a model down, everything in it. */
final class ModelText {
    private final StringBuilder text = new StringBuilder();

    private ModelText() {}

    static String of(Model model) {
        ModelText text = new ModelText();
        model.components().forEach(text::component);
        model.tests().forEach(text::test);
        return text.text.toString();
    }

    private void line(int depth, String content) {
        text.append("  ".repeat(depth)).append(content).append('\n');
    }

    private static <T> String join(List<T> list, java.util.function.Function<T, String> show) {
        return list.stream().map(show).collect(Collectors.joining(", "));
    }

    private void component(Component component) {
        List<String> head = new ArrayList<>(List.of("component " + component.qualifiedName()));
        if (component.layer() != Component.Layer.LOGIC) {
            head.add(component.layer().toString().toLowerCase());
        }
        if (component.platform()) {
            head.add("platform");
        }
        if (component.deploy()) {
            head.add("deploy");
        }
        if (component.profile() == Component.Profile.EVENT_DRIVEN) {
            head.add("event-driven, capacity " + component.queueCapacity());
        }
        if (component.cycle() != Stereotypes.DEFAULT_CYCLE) {
            head.add("cycle " + component.cycle());
        }
        if (!component.refines().isEmpty()) {
            head.add("refines " + String.join(" ", component.refines()));
        }
        line(0, String.join(", ", head));
        component.parameters().forEach(p -> line(1, parameter(p)));
        component.constants().forEach(c -> line(1, "constant " + variable(c)));
        component.ports().forEach(p -> line(1, port(p)));
        if (component.body() instanceof Component.Composite composite) {
            composite.parts().forEach(p -> line(1, part(p)));
            composite
                    .connections()
                    .forEach(c -> line(1, "connect " + c.source() + " -> " + c.target()));
            component.requirements().forEach(a -> automaton("requirement", a));
        } else if (component.body() instanceof Component.Atomic atomic) {
            atomic.automata().forEach(a -> automaton("automaton", a));
        }
        component
                .invariants()
                .forEach(i -> line(1, "invariant " + i.name() + ": " + show(i.condition())));
    }

    private static String parameter(Parameter parameter) {
        return "parameter "
                + parameter.name()
                + ": "
                + parameter.type().name()
                + parameter.initial().map(i -> " = " + show(i)).orElse("");
    }

    private static String variable(Variable variable) {
        return variable.name() + ": " + variable.type().name() + " = " + show(variable.initial());
    }

    private static String port(Port port) {
        return (port.isInput() ? "in " : "out ")
                + port.name()
                + ": "
                + port.type().name()
                + (port.total() ? " total" : "")
                + (port.latched() ? " latched" : "")
                + port.first().map(first -> " from " + first).orElse("")
                + (port.isInput() ? "" : " delay " + port.delay());
    }

    private static String part(Component.Part part) {
        return "part "
                + part.name()
                + ": "
                + part.component().qualifiedName()
                + "("
                + join(part.arguments(), ModelText::show)
                + ")";
    }

    private void automaton(String kind, Automaton automaton) {
        line(
                1,
                (kind
                                        + " "
                                        + automaton.name()
                                        + " "
                                        + automaton.completion()
                                        + " "
                                        + automaton.omitted())
                                .toLowerCase()
                                .replace("  ", " ")
                        + (automaton.violated() == Automaton.Violated.STOP ? "" : " continue"));
        line(2, "states " + String.join(", ", automaton.states()));
        automaton.variables().forEach(v -> line(2, "variable " + variable(v)));
        for (Automaton.Initial initial : automaton.initials()) {
            line(
                    2,
                    "initial "
                            + automaton.states().get(initial.state())
                            + effects(initial.sends(), initial.assignments()));
        }
        for (Automaton.Transition t : automaton.transitions()) {
            line(
                    2,
                    automaton.states().get(t.source())
                            + " -> "
                            + automaton.states().get(t.target())
                            + t.guard().map(g -> " [" + show(g) + "]").orElse("")
                            + (t.matches().isEmpty()
                                    ? ""
                                    : " {" + join(t.matches(), m -> match(m)) + "}")
                            + effects(t.sends(), t.assignments())
                            + t.body().map(ModelText::standing).orElse(""));
        }
    }

    private static String standing(Automaton.Body body) {
        return " as " + body.standing().toString().toLowerCase();
    }

    private static String effects(
            List<Automaton.Send> sends, List<Automaton.Assignment> assignments) {
        List<String> all = new ArrayList<>();
        sends.forEach(s -> all.add(s.port().name() + " = " + emission(s.emission())));
        assignments.forEach(a -> all.add(a.variable().name() + " := " + show(a.value())));
        return all.isEmpty() ? "" : " / {" + String.join(", ", all) + "}";
    }

    private static String match(Automaton.Match match) {
        return match.port().name() + pattern(match.pattern());
    }

    private static String pattern(Automaton.Pattern pattern) {
        if (pattern instanceof Automaton.OneOf values) {
            return values.values().size() == 1
                    ? " == " + show(values.values().get(0))
                    : " in {" + join(values.values(), ModelText::show) + "}";
        }
        return pattern instanceof Automaton.Absent ? " absent" : " present";
    }

    private static String emission(Automaton.Emission emission) {
        if (emission instanceof Automaton.Messages messages) {
            return messages.values().size() == 1
                    ? show(messages.values().get(0))
                    : "[" + join(messages.values(), ModelText::show) + "]";
        }
        return emission instanceof Automaton.Silence ? "--" : "?";
    }

    private static String show(Expression expression) {
        if (expression instanceof Expression.Constant constant) {
            return constant.value().toString();
        }
        if (expression instanceof Expression.PortRead read) {
            return read.port().name();
        }
        if (expression instanceof Expression.VariableRead read) {
            return read.variable().name();
        }
        if (expression instanceof Expression.ParameterRead read) {
            return read.parameter().name();
        }
        if (expression instanceof Expression.AttributeRead read) {
            return show(read.object()) + "#" + read.index();
        }
        if (expression instanceof Expression.PortMatches matches) {
            return matches.port().name() + pattern(matches.pattern());
        }
        if (expression instanceof Expression.Unary unary) {
            return unary.operator() + "(" + show(unary.operand()) + ")";
        }
        if (expression instanceof Expression.Binary b) {
            return "(" + show(b.left()) + " " + b.operator() + " " + show(b.right()) + ")";
        }
        if (expression instanceof Expression.Conditional c) {
            return "("
                    + show(c.condition())
                    + " ? "
                    + show(c.then())
                    + " : "
                    + show(c.otherwise())
                    + ")";
        }
        if (expression instanceof Expression.IsIn in) {
            return "(" + show(in.element()) + " isin {" + join(in.set(), ModelText::show) + "})";
        }
        if (expression instanceof Expression.Cast cast) {
            return "(" + cast.type().name() + ") " + show(cast.operand());
        }
        throw new AssertionError(expression);
    }

    private void test(StreamTest test) {
        line(
                0,
                "test "
                        + test.suite()
                        + "#"
                        + test.name()
                        + " for "
                        + test.component().qualifiedName()
                        + "("
                        + join(test.arguments(), Value::toString)
                        + ")");
        for (Letter letter : test.inputs()) {
            List<String> messages = new ArrayList<>();
            letter.messages().forEach((port, values) -> messages.add(port + ": " + values));
            line(1, "input " + (messages.isEmpty() ? "--" : String.join(", ", messages)));
        }
        test.expected().forEach((port, slices) -> line(1, "expect " + port + ": " + slices));
    }
}
