package arcomat.generate;

import arcomat.generate.view.FieldView;
import arcomat.generate.view.MonitorView.GoView;
import arcomat.generate.view.MonitorView.SectionView;
import arcomat.generate.view.MonitorView.StateView;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Send;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Variable;
import arcomat.semantics.Behaviour;
import arcomat.semantics.Fault;
import arcomat.semantics.Guards;
import arcomat.semantics.Rewriting;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** The steps of a requirement: when they are possible, what they promise and where they lead. */
final class MonitorSteps {
    private static final int MOST_NAMED_STATES = 200;
    private static final int MOST_TRANSITIONS = 60;

    private final Component watched;
    private final Automaton automaton;
    private final Set<String> owned;
    private final FileContext context;
    private final ExpressionText text;
    private final Formulas formulas;
    private final Guards guards;

    /**
     * @param watched the component of the model
     * @param context of the class to be written
     */
    MonitorSteps(Component watched, Automaton automaton, FileContext context) {
        this.watched = watched;
        this.automaton = automaton;
        this.owned = Behaviour.owned(watched, automaton);
        this.context = context;
        this.text = context.expressions();
        this.formulas = new Formulas(text);
        this.guards = new Guards(watched.profile());
    }

    boolean named() {
        return automaton.states().size() <= MOST_NAMED_STATES;
    }

    private String label(int state) {
        return named() ? context.members().state(state) : String.valueOf(state);
    }

    /** The parameter that holds the values of the variables. */
    String values() {
        return context.members().local("variables", "");
    }

    List<GoView> initials() {
        List<GoView> initials = new ArrayList<>();
        for (Automaton.Initial initial : automaton.initials()) {
            text.at(watched.name() + ", initial (line " + Places.line(initial.span()) + ")");
            String cause =
                    "line "
                            + Places.line(initial.span())
                            + ": initial "
                            + automaton.states().get(initial.state());
            initials.add(
                    new GoView(
                            Places.quote(initial.span()),
                            "",
                            text.literal(cause),
                            label(initial.state()),
                            values(initial.assignments(), true),
                            promises(initial.sends()),
                            false));
        }
        return initials;
    }

    List<SectionView> sections() {
        List<List<Integer>> chunks = new ArrayList<>();
        List<Integer> chunk = new ArrayList<>();
        for (int state = 0; state < automaton.states().size(); state++) {
            for (int i = 0; i < automaton.transitions().size(); i++) {
                if (automaton.transitions().get(i).source() == state) {
                    if (chunk.size() == MOST_TRANSITIONS) {
                        chunks.add(chunk);
                        chunk = new ArrayList<>();
                    }
                    chunk.add(i);
                }
            }
        }
        chunks.add(chunk);
        List<SectionView> sections = new ArrayList<>();
        for (List<Integer> some : chunks) {
            String number = String.valueOf(sections.size());
            sections.add(section(chunks.size() == 1 ? "" : "react" + number, some));
        }
        return sections;
    }

    private SectionView section(String method, List<Integer> transitions) {
        List<StateView> states = new ArrayList<>();
        Set<String> read = new LinkedHashSet<>();
        for (int first = 0; first < transitions.size(); ) {
            int source = automaton.transitions().get(transitions.get(first)).source();
            List<GoView> some = new ArrayList<>();
            int next = first;
            while (next < transitions.size()
                    && automaton.transitions().get(transitions.get(next)).source() == source) {
                Automaton.Transition transition =
                        automaton.transitions().get(transitions.get(next++));
                some.add(transition(transition));
                collectReads(transition, read);
            }
            states.add(new StateView(label(source), automaton.states().get(source), some));
            first = next;
        }
        return new SectionView(method, unpacked(read), states);
    }

    private List<FieldView> unpacked(Set<String> read) {
        List<FieldView> fields = new ArrayList<>();
        for (int i = 0; i < automaton.variables().size(); i++) {
            Variable variable = automaton.variables().get(i);
            if (read.contains(variable.name())) {
                String value = text.unboxed(values() + "[" + i + "]", variable.type());
                fields.add(
                        new FieldView(
                                text.type(variable.type()),
                                context.members().of(variable),
                                value,
                                ""));
            }
        }
        return fields;
    }

    private GoView transition(Automaton.Transition transition) {
        text.at(Fault.place(watched, automaton, transition));
        int checks = text.checksSoFar();
        Formula condition = formulas.of(guards.enabledWhen(transition));
        String cause =
                "line "
                        + Places.line(transition.span())
                        + ": "
                        + automaton.states().get(transition.source())
                        + " -> "
                        + automaton.states().get(transition.target());
        String enabled = condition.equals(Formula.TRUE) ? "" : text.text(condition).text();
        String values = values(transition.assignments(), false);
        List<String> promises = promises(transition.sends());
        return new GoView(
                Places.quote(transition.span()),
                enabled,
                text.literal(cause),
                label(transition.target()),
                values,
                promises,
                text.checksSoFar() > checks);
    }

    private String values(List<Assignment> assignments, boolean first) {
        if (assignments.isEmpty() && !first) {
            return values();
        }
        List<String> values = new ArrayList<>();
        for (int i = 0; i < automaton.variables().size(); i++) {
            Variable variable = automaton.variables().get(i);
            String kept =
                    first
                            ? text.boxed(read(variable), variable.type(), variable.name())
                            : values() + "[" + i + "]";
            values.add(
                    assignments.stream()
                            .filter(a -> a.variable().name().equals(variable.name()))
                            .map(a -> text.boxed(a.value(), variable.type(), variable.name()))
                            .findFirst()
                            .orElse(kept));
        }
        return "values(" + String.join(", ", values) + ")";
    }

    private static Expression read(Variable variable) {
        return new Expression.VariableRead(variable, variable.span());
    }

    private List<String> promises(List<Send> sends) {
        return watched.outputs().stream().map(port -> promise(port, sends)).toList();
    }

    private String promise(Port port, List<Send> sends) {
        if (!owned.contains(port.name())) {
            return anything(port);
        }
        for (Send send : sends) {
            if (send.port().name().equals(port.name())) {
                return promise(port, send.emission());
            }
        }
        return automaton.omitted() == Automaton.Omitted.SILENT ? "SILENCE" : anything(port);
    }

    private String promise(Port port, Automaton.Emission emission) {
        if (emission instanceof Automaton.Messages messages) {
            List<String> objects =
                    messages.values().stream()
                            .map(value -> text.object(value, port.type(), port.name()))
                            .toList();
            return objects.size() == 1
                    ? objects.get(0)
                    : objects.isEmpty() ? "SILENCE" : "several(" + String.join(", ", objects) + ")";
        }
        return emission instanceof Automaton.Silence ? "SILENCE" : "ANY_MESSAGE";
    }

    private static String anything(Port port) {
        return port.total() ? "ANY_MESSAGE" : "ANYTHING";
    }

    /** Empty where an input without a transition is forbidden. */
    List<GoView> completion() {
        Automaton.Completion completion = automaton.completion();
        String kind = completion.name().toLowerCase(Locale.ROOT);
        String cause =
                "\"no transition fits in \" + name("
                        + context.members().state()
                        + ") + \", completion "
                        + kind
                        + "\"";
        return switch (completion) {
            case ERROR -> List.of();
            case CHAOS -> List.of(completed(cause, "CHAOS", List.of()));
            case OUTPUT -> List.of(completed(cause, context.members().state(), List.of()));
            case IGNORE ->
                    List.of(
                            completed(
                                    cause,
                                    context.members().state(),
                                    watched.outputs().stream()
                                            .map(port -> promise(port, List.of(silent(port))))
                                            .toList()));
        };
    }

    private static Send silent(Port port) {
        return new Send(port, new Automaton.Silence());
    }

    private GoView completed(String cause, String target, List<String> promises) {
        List<String> open = watched.outputs().stream().map(MonitorSteps::anything).toList();
        List<String> all = promises.isEmpty() ? open : promises;
        return new GoView("", "", cause, target, values(), all, false);
    }

    private static void collectReads(Automaton.Transition transition, Set<String> read) {
        transition.guard().ifPresent(guard -> collectReads(guard, read));
        transition.matches().forEach(match -> collectReads(match.pattern(), read));
        for (Send send : transition.sends()) {
            if (send.emission() instanceof Automaton.Messages messages) {
                messages.values().forEach(value -> collectReads(value, read));
            }
        }
        transition.assignments().forEach(a -> collectReads(a.value(), read));
    }

    private static void collectReads(Automaton.Pattern pattern, Set<String> read) {
        if (pattern instanceof Automaton.OneOf oneOf) {
            oneOf.values().forEach(value -> collectReads(value, read));
        }
    }

    private static void collectReads(Expression expression, Set<String> read) {
        Rewriting.visit(
                expression,
                e -> {
                    if (e instanceof Expression.VariableRead variable) {
                        read.add(variable.variable().name());
                    } else if (e instanceof Expression.PortMatches matches) {
                        collectReads(matches.pattern(), read);
                    }
                });
    }
}
