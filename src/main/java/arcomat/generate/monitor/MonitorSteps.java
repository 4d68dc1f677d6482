package arcomat.generate.monitor;

import arcomat.generate.language.Places;
import arcomat.generate.language.Text;
import arcomat.generate.text.Exclusion;
import arcomat.generate.text.ExpressionWriter;
import arcomat.generate.text.FileContext;
import arcomat.generate.text.Formula;
import arcomat.generate.text.FormulaBuilder;
import arcomat.generate.text.RuntimeChecks;
import arcomat.generate.text.WrittenExpressions;
import arcomat.generate.view.HeadView.FieldView;
import arcomat.generate.view.MonitorView.GoView;
import arcomat.generate.view.MonitorView.MonitorSectionView;
import arcomat.generate.view.MonitorView.MonitorStateView;
import arcomat.generate.view.MonitorView.PromiseView;
import arcomat.generate.view.MonitorView.SetView;
import arcomat.generate.views.AtomicViews;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Send;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Guards;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/** The steps of a requirement: when they are possible, what they promise and where they lead. */
final class MonitorSteps {
    private static final int MOST_TRANSITIONS = 60;

    private final Component watched;
    private final Automaton automaton;
    private final Set<String> owned;
    private final FileContext context;
    private final Guards guards;

    /**
     * @param watched the component of the model
     * @param context of the class to be written
     */
    MonitorSteps(Component watched, Automaton automaton, FileContext context) {
        this.watched = watched;
        this.automaton = automaton;
        this.owned = ComponentSemantics.owned(watched, automaton);
        this.context = context;
        this.guards = new Guards(watched.profile());
    }

    private String label(int state) {
        return AtomicViews.label(context, automaton, state);
    }

    private String stateName(int state) {
        return automaton.states().get(state);
    }

    private static String cause(Span span, String step) {
        return "line " + Places.line(span) + ": " + step;
    }

    private static String code(ExpressionWriter text, Expression value, Type type, String what) {
        return text.express("code", type, text.inRange(value, type, what)).text();
    }

    List<GoView> initials() {
        return automaton.initials().stream().map(this::initial).toList();
    }

    private GoView initial(Automaton.Initial initial) {
        String place = watched.name() + ", initial (line " + Places.line(initial.span()) + ")";
        ExpressionWriter text = context.expressions().at(place);
        // Of all variables: before the first step none has a value.
        List<SetView> values = new ArrayList<>();
        for (Variable variable : automaton.variables()) {
            Expression value =
                    assigned(initial.assignments(), variable)
                            .orElse(new Expression.VariableRead(variable, variable.span()));
            String code = code(text, value, variable.type(), variable.name());
            values.add(new SetView(values.size(), code));
        }
        return new GoView(
                Places.quote(initial.span()),
                "",
                text.literal(cause(initial.span(), "initial " + stateName(initial.state()))),
                label(initial.state()),
                values,
                promises(text, initial.sends()),
                false,
                false);
    }

    /** The transitions, state by state, in methods that stay small. */
    List<MonitorSectionView> sections() {
        List<Automaton.Transition> ordered =
                automaton.transitions().stream()
                        .sorted(Comparator.comparingInt(Automaton.Transition::source))
                        .toList();
        List<MonitorSectionView> sections = new ArrayList<>();
        boolean one = ordered.size() <= MOST_TRANSITIONS;
        for (int first = 0; first == 0 || first < ordered.size(); first += MOST_TRANSITIONS) {
            int end = Math.min(first + MOST_TRANSITIONS, ordered.size());
            String method = one ? "" : "react" + sections.size();
            sections.add(section(method, ordered.subList(first, end)));
        }
        return sections;
    }

    private MonitorSectionView section(String method, List<Automaton.Transition> transitions) {
        Map<Integer, List<Automaton.Transition>> bySource = new LinkedHashMap<>();
        for (Automaton.Transition each : transitions) {
            bySource.computeIfAbsent(each.source(), source -> new ArrayList<>()).add(each);
        }
        List<MonitorStateView> states = new ArrayList<>();
        bySource.forEach(
                (source, own) ->
                        states.add(
                                new MonitorStateView(label(source), stateName(source), ways(own))));
        return new MonitorSectionView(method, unpacked(transitions), states);
    }

    /** The variables that are read, out of what a monitor keeps. */
    private List<FieldView> unpacked(List<Automaton.Transition> transitions) {
        ExpressionWriter text = context.expressions();
        List<FieldView> fields = new ArrayList<>();
        for (int i = 0; i < automaton.variables().size(); i++) {
            Variable variable = automaton.variables().get(i);
            boolean read =
                    transitions.stream()
                            .flatMap(WrittenExpressions::of)
                            .anyMatch(written -> reads(written, variable));
            if (read) {
                Text position = Text.primary(String.valueOf(i));
                String value = text.express("decoded", variable.type(), position).text();
                String name = context.members().of(variable);
                fields.add(new FieldView(text.type(variable.type()), name, value, ""));
            }
        }
        return fields;
    }

    private static boolean reads(Expression expression, Variable variable) {
        return expression.contains(
                e ->
                        e instanceof Expression.VariableRead r
                                && r.variable().name().equals(variable.name()));
    }

    private List<GoView> ways(List<Automaton.Transition> transitions) {
        List<Formula> conditions = transitions.stream().map(this::condition).toList();
        List<GoView> ways = new ArrayList<>();
        for (Automaton.Transition each : transitions) {
            Formula own = conditions.get(ways.size());
            List<Formula> later = conditions.subList(ways.size() + 1, conditions.size());
            ways.add(transition(each, own, excludesAll(own, later)));
        }
        return ways;
    }

    /** Whether none of some can hold as well, nor go wrong. */
    private static boolean excludesAll(Formula own, List<Formula> others) {
        return !others.isEmpty()
                && others.stream().allMatch(o -> Exclusion.contradict(own, o.beforeFailing()));
    }

    private Formula condition(Automaton.Transition transition) {
        return new FormulaBuilder(writer(transition)).of(enabledWhen(transition));
    }

    private Expression enabledWhen(Automaton.Transition transition) {
        return guards.enabledWhen(automaton, transition);
    }

    private ExpressionWriter writer(Automaton.Transition transition) {
        return context.expressions().careful().at(Fault.place(watched, automaton, transition));
    }

    /** A transition is only tried: what goes wrong in it is noted. */
    private GoView transition(Automaton.Transition transition, Formula enabled, boolean alone) {
        ExpressionWriter text = writer(transition);
        RuntimeChecks checks = text.checks();
        return new GoView(
                Places.quote(transition.span()),
                enabled.equals(Formula.TRUE) ? "" : text.of(enabled).text(),
                text.literal(cause(transition.span(), automaton.arrow(transition))),
                label(transition.target()),
                values(text, transition.assignments()),
                promises(text, transition.sends()),
                RuntimeChecks.dividesAnywhere(enabledWhen(transition))
                        || checks.areNeeded(transition.sends())
                        || checks.areNeededFor(transition.assignments()),
                alone);
    }

    private List<SetView> values(ExpressionWriter text, List<Assignment> assignments) {
        List<SetView> values = new ArrayList<>();
        for (int i = 0; i < automaton.variables().size(); i++) {
            int index = i;
            Variable variable = automaton.variables().get(i);
            assigned(assignments, variable)
                    .map(value -> code(text, value, variable.type(), variable.name()))
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
    private List<PromiseView> promises(ExpressionWriter text, List<Send> sends) {
        List<PromiseView> promises = new ArrayList<>();
        for (int i = 0; i < watched.outputs().size(); i++) {
            promise(i, watched.outputs().get(i), text, sends).ifPresent(promises::add);
        }
        return promises;
    }

    private Optional<PromiseView> promise(
            int position, Port port, ExpressionWriter text, List<Send> sends) {
        if (!owned.contains(port.name())) {
            return Optional.of(anything(position, port));
        }
        for (Send send : sends) {
            if (send.port().name().equals(port.name())) {
                return send.emission()
                        .match(
                                messages -> Optional.of(promise(position, port, text, messages)),
                                Optional::empty,
                                () -> Optional.of(any(position)));
            }
        }
        return automaton.omitted() == Automaton.Omitted.SILENT
                ? Optional.empty()
                : Optional.of(anything(position, port));
    }

    private static PromiseView promise(
            int position, Port port, ExpressionWriter text, Automaton.Messages messages) {
        List<String> codes =
                messages.values().stream()
                        .map(value -> code(text, value, port.type(), port.name()))
                        .toList();
        return new PromiseView(position, codes, false, false);
    }

    private static PromiseView any(int position) {
        return new PromiseView(position, List.of(), true, false);
    }

    /** A port that always has a message has one when nothing is said about it. */
    private static PromiseView anything(int position, Port port) {
        return new PromiseView(position, List.of(), port.total(), !port.total());
    }

    /** Empty where an input without a transition is forbidden. */
    List<GoView> completion() {
        String state = context.members().state();
        return switch (automaton.completion()) {
            case ERROR -> List.of();
            case CHAOS -> List.of(completed("CHAOS", open()));
            case OUTPUT -> List.of(completed(state, open()));
            case IGNORE -> List.of(completed(state, silent()));
        };
    }

    private List<PromiseView> open() {
        return IntStream.range(0, watched.outputs().size())
                .mapToObj(i -> anything(i, watched.outputs().get(i)))
                .toList();
    }

    private List<PromiseView> silent() {
        List<Send> silence =
                watched.outputs().stream()
                        .map(port -> new Send(port, new Automaton.Silence()))
                        .toList();
        return promises(context.expressions(), silence);
    }

    private GoView completed(String target, List<PromiseView> promises) {
        String kind = automaton.completion().name().toLowerCase(Locale.ROOT);
        String cause = context.expressions().literal(kind);
        return new GoView("", "", cause, target, List.of(), promises, false, false);
    }
}
