package arcomat.generate;

import arcomat.generate.view.FieldView;
import arcomat.generate.view.MonitorView.GoView;
import arcomat.generate.view.MonitorView.PromiseView;
import arcomat.generate.view.MonitorView.SectionView;
import arcomat.generate.view.MonitorView.SetView;
import arcomat.generate.view.MonitorView.StateView;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Send;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Variable;
import arcomat.semantics.automaton.Behaviour;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Guards;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** The steps of a requirement: when they are possible, what they promise and where they lead. */
final class MonitorSteps {
    private static final int MOST_NAMED_STATES = 200;
    private static final int MOST_TRANSITIONS = 60;

    private final Component watched;
    private final Automaton automaton;
    private final Set<String> owned;
    private final FileContext context;

    /** Of what is done once, at the beginning. */
    private final ExpressionText first;

    /** Of transitions, which are only tried. */
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
        this.first = context.expressions();
        this.text = first.careful();
        this.formulas = new Formulas(text);
        this.guards = new Guards(watched.profile());
    }

    boolean named() {
        return automaton.states().size() <= MOST_NAMED_STATES;
    }

    private String label(int state) {
        return named() ? context.members().state(state) : String.valueOf(state);
    }

    List<GoView> initials() {
        List<GoView> initials = new ArrayList<>();
        for (Automaton.Initial initial : automaton.initials()) {
            first.at(watched.name() + ", initial (line " + Places.line(initial.span()) + ")");
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
                            firstValues(initial.assignments()),
                            promises(first, initial.sends()),
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
                fields.add(
                        new FieldView(
                                text.type(variable.type()),
                                context.members().of(variable),
                                text.decoded(i, variable.type()),
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
        List<SetView> values = values(transition.assignments());
        List<PromiseView> promises = promises(text, transition.sends());
        return new GoView(
                Places.quote(transition.span()),
                enabled,
                text.literal(cause),
                label(transition.target()),
                values,
                promises,
                text.checksSoFar() > checks);
    }

    /** Of all variables: before the first step none has a value. */
    private List<SetView> firstValues(List<Assignment> assignments) {
        List<SetView> values = new ArrayList<>();
        for (int i = 0; i < automaton.variables().size(); i++) {
            Variable variable = automaton.variables().get(i);
            Expression value =
                    assigned(assignments, variable)
                            .orElse(new Expression.VariableRead(variable, variable.span()));
            values.add(new SetView(i, first.code(value, variable.type(), variable.name())));
        }
        return values;
    }

    private List<SetView> values(List<Assignment> assignments) {
        List<SetView> values = new ArrayList<>();
        for (int i = 0; i < automaton.variables().size(); i++) {
            int index = i;
            Variable variable = automaton.variables().get(i);
            assigned(assignments, variable)
                    .map(value -> text.code(value, variable.type(), variable.name()))
                    .ifPresent(value -> values.add(new SetView(index, value)));
        }
        return values;
    }

    private static Optional<Expression> assigned(List<Assignment> assignments, Variable variable) {
        return assignments.stream()
                .filter(a -> a.variable().name().equals(variable.name()))
                .map(Assignment::value)
                .findFirst();
    }

    /** What is promised about the outputs; those without a promise are silent. */
    private List<PromiseView> promises(ExpressionText words, List<Send> sends) {
        List<PromiseView> promises = new ArrayList<>();
        int position = 0;
        for (Port port : watched.outputs()) {
            promise(position++, port, words, sends).ifPresent(promises::add);
        }
        return promises;
    }

    private Optional<PromiseView> promise(
            int position, Port port, ExpressionText words, List<Send> sends) {
        if (!owned.contains(port.name())) {
            return Optional.of(anything(position, port));
        }
        for (Send send : sends) {
            if (send.port().name().equals(port.name())) {
                return promise(position, port, words, send.emission());
            }
        }
        return automaton.omitted() == Automaton.Omitted.SILENT
                ? Optional.empty()
                : Optional.of(anything(position, port));
    }

    private static Optional<PromiseView> promise(
            int position, Port port, ExpressionText words, Automaton.Emission emission) {
        if (emission instanceof Automaton.Messages messages) {
            List<String> codes =
                    messages.values().stream()
                            .map(value -> words.code(value, port.type(), port.name()))
                            .toList();
            return Optional.of(new PromiseView(position, codes, false, false));
        }
        return emission instanceof Automaton.Silence
                ? Optional.empty()
                : Optional.of(new PromiseView(position, List.of(), true, false));
    }

    /** A port that always has a message has one when nothing is said about it. */
    private static PromiseView anything(int position, Port port) {
        return new PromiseView(position, List.of(), port.total(), !port.total());
    }

    /** Empty where an input without a transition is forbidden. */
    List<GoView> completion() {
        Automaton.Completion completion = automaton.completion();
        String state = context.members().state();
        return switch (completion) {
            case ERROR -> List.of();
            case CHAOS -> List.of(completed("CHAOS", open()));
            case OUTPUT -> List.of(completed(state, open()));
            case IGNORE -> List.of(completed(state, silent()));
        };
    }

    private List<PromiseView> open() {
        List<PromiseView> open = new ArrayList<>();
        for (Port port : watched.outputs()) {
            open.add(anything(open.size(), port));
        }
        return open;
    }

    private List<PromiseView> silent() {
        List<Send> silence =
                watched.outputs().stream()
                        .map(port -> new Send(port, new Automaton.Silence()))
                        .toList();
        return promises(text, silence);
    }

    private GoView completed(String target, List<PromiseView> promises) {
        String kind = automaton.completion().name().toLowerCase(Locale.ROOT);
        return new GoView("", "", text.literal(kind), target, List.of(), promises, false);
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
        expression.visit(
                e -> {
                    if (e instanceof Expression.VariableRead variable) {
                        read.add(variable.variable().name());
                    } else if (e instanceof Expression.PortMatches matches) {
                        collectReads(matches.pattern(), read);
                    }
                });
    }
}
