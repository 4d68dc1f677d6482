package arcomat.generate;

import arcomat.generate.template.ShippedTemplates;
import arcomat.generate.text.WrittenExpressions;
import arcomat.generate.view.ControllerView;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.source.ArrayNames;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Writes a synthesised controller as the text of a model: an atomic component with one automaton
 * that sends constants, has no variables, and compares its inputs with constants. And what it
 * keeps, where that is asked of a decomposed component.
 */
public final class ControllerText {
    private final Component component;
    private final Automaton automaton;
    private final ModelWords words;

    private ControllerText(Component component) {
        this.component = component;
        this.automaton = component.automata().get(0);
        this.words = new ModelWords(component);
    }

    /**
     * @param remarks lines that say where the controller comes from
     */
    public static GeneratedFile of(Component controller, List<String> remarks) {
        ControllerView view = new ControllerText(controller).view(remarks);
        return file(controller.packageName(), controller.name(), view);
    }

    /**
     * A component without parts that is asked the same as a decomposed one: its ports and the texts
     * of its automata. A sole one leaves the outputs alone that it does not write.
     *
     * @param name of the new component, without its package
     * @param imports of the files in which the automata stand, qualified names or wildcards
     * @param remarks lines that say where it comes from
     */
    public static GeneratedFile required(
            Component component, String name, Collection<String> imports, List<String> remarks) {
        List<Automaton> automata = component.requirements();
        List<Port> ports =
                automata.size() > 1
                        ? component.ports()
                        : component.ports().stream()
                                .filter(each -> isSaid(each, automata.get(0)))
                                .toList();
        ControllerText text = new ControllerText(component);
        ControllerView view =
                new ControllerView(
                        component.packageName(),
                        Stream.concat(
                                        imports.stream(),
                                        text.words.imports().stream()
                                                .filter(each -> !isKnown(each, imports)))
                                .toList(),
                        remarks,
                        text.layer(),
                        name,
                        List.of(),
                        text.isInstant(),
                        ports.stream().flatMap(port -> text.declared(port).stream()).toList(),
                        automata.stream().map(each -> each.span().text()).toList(),
                        "",
                        List.of(),
                        "",
                        List.of(),
                        List.of());
        return file(component.packageName(), name, view);
    }

    private static boolean isKnown(String type, Collection<String> imports) {
        String all = type.substring(0, type.lastIndexOf('.')) + ".*";
        return imports.contains(type) || imports.contains(all);
    }

    private static boolean isSaid(Port port, Automaton automaton) {
        return port.isInput() || ComponentSemantics.written(automaton).contains(port.name());
    }

    private static GeneratedFile file(String packageName, String name, ControllerView view) {
        String folder = packageName.replace('.', '/');
        String path = (folder.isEmpty() ? "" : folder + "/") + name + ".arc";
        return new GeneratedFile(path, ShippedTemplates.render("arc", "controller.ftl", view));
    }

    private String layer() {
        return component.layer() == Component.Layer.LOGIC
                ? ""
                : component.layer().name().toLowerCase(Locale.ROOT);
    }

    private boolean isInstant() {
        return component.outputs().stream().allMatch(port -> port.delay() == 0);
    }

    private ControllerView view(List<String> remarks) {
        Automaton.Initial initial = automaton.initials().get(0);
        return new ControllerView(
                component.packageName(),
                words.imports(),
                remarks,
                layer(),
                component.name(),
                component.refines(),
                isInstant(),
                component.ports().stream().flatMap(port -> declared(port).stream()).toList(),
                List.of(),
                automaton.completion().name().toLowerCase(Locale.ROOT),
                automaton.states(),
                automaton.states().get(initial.state()),
                messages(initial.sends()),
                groups());
    }

    /** An array is declared by its first element. */
    private Optional<ControllerView.DeclarationView> declared(Port port) {
        String name = port.name();
        if (!ArrayNames.isElement(name)) {
            return Optional.of(port(port, name));
        }
        String array = ArrayNames.array(name);
        Set<String> names = component.ports().stream().map(Port::name).collect(Collectors.toSet());
        return name.equals(ArrayNames.element(array, 0))
                ? Optional.of(port(port, ArrayNames.element(array, ArrayNames.size(array, names))))
                : Optional.empty();
    }

    private ControllerView.DeclarationView port(Port port, String name) {
        boolean instant = !port.isInput() && port.delay() == 0;
        String type = words.type(port.type());
        return new ControllerView.DeclarationView(
                port.isInput(), port.total(), instant, type, name);
    }

    private List<List<ControllerView.RuleView>> groups() {
        Map<Integer, List<ControllerView.RuleView>> groups = new TreeMap<>();
        for (Automaton.Transition transition : automaton.transitions()) {
            groups.computeIfAbsent(transition.source(), source -> new ArrayList<>())
                    .add(rule(transition));
        }
        return List.copyOf(groups.values());
    }

    /** What is said about a single port by patterns becomes an item. */
    private ControllerView.RuleView rule(Automaton.Transition transition) {
        List<ModelWords.Item> items = new ArrayList<>();
        transition.matches().forEach(m -> items.add(words.item(m.port(), List.of(m.pattern()))));
        List<Expression> guards = new ArrayList<>();
        transition.guard().stream()
                .flatMap(all -> WrittenExpressions.row(all, BinaryOperator.AND).stream())
                .forEach(
                        guard ->
                                words.item(guard)
                                        .ifPresentOrElse(items::add, () -> guards.add(guard)));
        Map<Integer, String> byPort = new TreeMap<>();
        items.forEach(item -> byPort.put(component.ports().indexOf(item.port()), item.text()));
        boolean stays = transition.source() == transition.target();
        return new ControllerView.RuleView(
                automaton.states().get(transition.source()),
                stays ? "" : automaton.states().get(transition.target()),
                words.conjunction(guards),
                List.copyOf(byPort.values()),
                messages(transition.sends()));
    }

    private List<String> messages(List<Automaton.Send> sends) {
        return sends.stream().map(words::message).toList();
    }
}
