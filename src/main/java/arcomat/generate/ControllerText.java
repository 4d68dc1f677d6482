package arcomat.generate;

import arcomat.generate.view.ControllerView;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Writes a synthesised controller as the text of a model: an atomic component with one automaton
 * that sends constants, has no variables, and compares its inputs with constants.
 */
public final class ControllerText {
    private final Component component;
    private final Automaton automaton;
    private final ModelWords words;

    private ControllerText(Component component) {
        this.component = component;
        this.automaton = ((Component.Atomic) component.body()).automata().get(0);
        this.words = new ModelWords(component);
    }

    /**
     * @param remarks lines that say where the controller comes from
     */
    public static GeneratedFile of(Component controller, List<String> remarks) {
        String folder = controller.packageName().replace('.', '/');
        String path = (folder.isEmpty() ? "" : folder + "/") + controller.name() + ".arc";
        ControllerView view = new ControllerText(controller).view(remarks);
        return new GeneratedFile(path, OwnTemplate.render("arc", "controller.ftl", view));
    }

    private ControllerView view(List<String> remarks) {
        Automaton.Initial initial = automaton.initials().get(0);
        return new ControllerView(
                component.packageName(),
                words.imports(),
                remarks,
                layer(),
                component.name(),
                String.join(", ", component.refines()),
                timing(),
                component.ports().stream().map(this::port).toList(),
                automaton.completion().name().toLowerCase(Locale.ROOT),
                automaton.states(),
                automaton.states().get(initial.state()) + output(initial.sends()),
                groups());
    }

    private String layer() {
        return component.layer() == Component.Layer.LOGIC
                ? ""
                : "<<layer = \"" + component.layer().name().toLowerCase(Locale.ROOT) + "\">>";
    }

    private boolean isInstant() {
        return component.outputs().stream().allMatch(port -> port.delay() == 0);
    }

    private String timing() {
        return isInstant() ? "instant" : "";
    }

    private String port(Port port) {
        List<String> stereotypes = new ArrayList<>();
        if (port.total()) {
            stereotypes.add("total");
        }
        if (!port.isInput() && port.delay() == 0 && !isInstant()) {
            stereotypes.add("delay = \"0\"");
        }
        String prefix = stereotypes.isEmpty() ? "" : "<<" + String.join(", ", stereotypes) + ">> ";
        return prefix
                + (port.isInput() ? "in " : "out ")
                + words.type(port.type())
                + " "
                + port.name();
    }

    private List<List<String>> groups() {
        List<List<String>> groups = new ArrayList<>();
        for (int state = 0; state < automaton.states().size(); state++) {
            int source = state;
            List<String> group =
                    automaton.transitions().stream()
                            .filter(t -> t.source() == source)
                            .map(this::transition)
                            .toList();
            if (!group.isEmpty()) {
                groups.add(group);
            }
        }
        return groups;
    }

    private String transition(Automaton.Transition transition) {
        Map<Integer, String> items = new TreeMap<>();
        for (Automaton.Match match : transition.matches()) {
            items.put(
                    component.ports().indexOf(match.port()),
                    words.item(match.port(), List.of(match.pattern())));
        }
        List<Expression> guards = new ArrayList<>();
        transition.guard().ifPresent(guard -> split(guard, items, guards));
        String source = automaton.states().get(transition.source());
        String target = automaton.states().get(transition.target());
        return source
                + (transition.source() == transition.target() ? "" : " -> " + target)
                + (guards.isEmpty() ? "" : " [" + words.conjunction(guards) + "]")
                + (items.isEmpty() ? "" : " {" + String.join(", ", items.values()) + "}")
                + output(transition.sends());
    }

    /** What is said about a single port by patterns becomes an item. */
    private void split(Expression guard, Map<Integer, String> items, List<Expression> guards) {
        Optional<Expression.Binary> and = ModelWords.binary(guard, Expression.BinaryOperator.AND);
        if (and.isPresent()) {
            split(and.get().left(), items, guards);
            split(and.get().right(), items, guards);
            return;
        }
        Optional<Port> port = ModelWords.soleMatch(guard);
        if (port.isPresent()) {
            items.put(component.ports().indexOf(port.get()), words.alternatives(guard));
        } else {
            guards.add(guard);
        }
    }

    private String output(List<Automaton.Send> sends) {
        return sends.isEmpty()
                ? ""
                : sends.stream()
                        .map(send -> send.port().name() + " = " + words.message(send))
                        .collect(Collectors.joining(", ", " / {", "}"));
    }
}
