package arcomat.analysis.reachability;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Messages;
import arcomat.model.Automaton.Send;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Variable;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * The transition relation of an automaton at one instant, and what may be shown there, as formulas.
 *
 * @param <T> formulas of a {@link Logic}
 */
public final class SymbolicTransitions<T> implements RunProperty.Cases<T> {
    private final Subject subject;
    private final Logic<T> logic;
    private final Instant<T> at;
    private final Function<Port, T> earlier;

    /** Somewhere in a run: latched ports may have had a message where they have one now. */
    public SymbolicTransitions(Subject subject, Logic<T> logic, Instant<T> at) {
        this(subject, logic, at, at::has);
    }

    /**
     * @param earlier whether a latched port has had a message before
     */
    SymbolicTransitions(Subject subject, Logic<T> logic, Instant<T> at, Function<Port, T> earlier) {
        this.subject = subject;
        this.logic = logic;
        this.at = at;
        this.earlier = earlier;
    }

    public Instant<T> instant() {
        return at;
    }

    /** Whether a latched port has had a message before, and has lost its silence for good. */
    public T isLatched(Port port) {
        return earlier.apply(port);
    }

    /** What always holds: values are of their types, and events come one by one. */
    public T wellFormed() {
        boolean single = subject.component().profile() == Component.Profile.EVENT_DRIVEN;
        return single ? and(at.isWellTyped(), oneEvent()) : at.isWellTyped();
    }

    private T oneEvent() {
        List<T> one = new ArrayList<>();
        List<Port> events =
                subject.component().inputs().stream().filter(port -> !port.latched()).toList();
        for (Port here : events) {
            List<T> alone = new ArrayList<>();
            for (Port port : events) {
                alone.add(port.equals(here) ? at.has(port) : not(at.has(port)));
            }
            one.add(logic.and(alone));
        }
        return logic.or(one);
    }

    /** Latched ports do not lose their message until then. */
    T keepsLatched(Instant<T> next) {
        List<T> kept = new ArrayList<>();
        for (Port port : subject.latchable()) {
            kept.add(or(not(at.has(port)), next.has(port)));
        }
        return logic.and(kept);
    }

    private T silent() {
        return logic.and(
                subject.component().inputs().stream().map(port -> not(at.has(port))).toList());
    }

    private T and(T one, T other) {
        return logic.and(List.of(one, other));
    }

    private T and(T one, T two, T three) {
        return logic.and(List.of(one, two, three));
    }

    private T or(T one, T other) {
        return logic.or(List.of(one, other));
    }

    private T not(T condition) {
        return logic.not(condition);
    }

    /** That a condition is true. */
    public T holds(Expression condition) {
        return at.value(condition);
    }

    private List<Transition> transitions() {
        return subject.automaton().transitions();
    }

    private Preconditions preconditions(int transition) {
        return subject.preconditions().get(transition);
    }

    @Override
    public T reached(RunProperty.Reached reached) {
        return at.isIn(reached.state());
    }

    @Override
    public T enabled(RunProperty.Enabled enabled) {
        return enabled(enabled.transition());
    }

    @Override
    public T together(RunProperty.Together together) {
        int one = together.first();
        int two = together.second();
        T difference =
                switch (together.difference()) {
                    case ANY -> logic.of(true);
                    case OUTPUT -> and(goesWell(one), goesWell(two), differInOutput(one, two));
                    case TARGET -> and(goesWell(one), goesWell(two), differInTarget(one, two));
                };
        return and(enabled(one), enabled(two), difference);
    }

    /** No transition of a state may be taken, and no guard goes wrong. */
    @Override
    public T unhandled(RunProperty.Unhandled unhandled) {
        T silent = silent();
        return and(isUnhandled(unhandled.state()), unhandled.silent() ? silent : not(silent));
    }

    private T isUnhandled(int state) {
        List<T> answers = new ArrayList<>();
        for (int i = 0; i < transitions().size(); i++) {
            if (transitions().get(i).source() == state) {
                answers.add(holds(preconditions(i).dividesInGuard()));
                answers.add(holds(preconditions(i).enabled()));
            }
        }
        return and(at.isIn(state), not(logic.or(answers)));
    }

    @Override
    public T silenced(RunProperty.Silenced silenced) {
        int transition = silenced.transition();
        return and(
                isUnhandled(transitions().get(transition).source()),
                holds(preconditions(transition).enabledButForSilence()));
    }

    /** In the guard, or in the effect where the guard is true; ranges are those of effects. */
    @Override
    public T wrong(RunProperty.Wrong wrong) {
        int transition = wrong.transition();
        Preconditions when = preconditions(transition);
        return switch (wrong.kind()) {
            case DIVISION_BY_ZERO ->
                    meets(transition, when.dividesInGuard(), when.dividesInEffect());
            case OUTSIDE_RANGE ->
                    and(
                            enabled(transition),
                            not(holds(when.dividesInEffect())),
                            holds(preconditions(transition).leavesRange()));
        };
    }

    /** In the guard, or in the effect where the guard is true. */
    @Override
    public T overflow(RunProperty.Overflow overflow) {
        Preconditions when = preconditions(overflow.transition());
        return meets(overflow.transition(), when.wrapsInGuard(), when.wrapsInEffect());
    }

    private T meets(int transition, Expression inGuard, Expression inEffect) {
        return or(
                and(at.isIn(transitions().get(transition).source()), holds(inGuard)),
                and(enabled(transition), holds(inEffect)));
    }

    /** It goes to the next instant, and all goes well. */
    public T step(int transition, Instant<T> next) {
        List<T> all = new ArrayList<>();
        all.add(enabled(transition));
        all.add(goesWell(transition));
        all.add(next.isIn(transitions().get(transition).target()));
        for (Variable variable : subject.automaton().variables()) {
            all.add(next.is(variable, after(transition, variable), at));
        }
        return logic.and(all);
    }

    /** What it sends and assigns has a value that fits. */
    private T goesWell(int transition) {
        return and(
                not(holds(preconditions(transition).dividesInEffect())),
                not(holds(preconditions(transition).leavesRange())));
    }

    /** What a variable is after a transition. */
    private Expression after(int transition, Variable variable) {
        return assigned(transition, variable)
                .orElseGet(() -> new Expression.VariableRead(variable, variable.span()));
    }

    private Optional<Expression> assigned(int transition, Variable variable) {
        return transitions().get(transition).assignments().stream()
                .filter(each -> each.variable().name().equals(variable.name()))
                .map(Assignment::value)
                .findFirst();
    }

    /** It may be taken; its guard does not go wrong. */
    private T enabled(int transition) {
        Preconditions when = preconditions(transition);
        return and(
                at.isIn(transitions().get(transition).source()),
                holds(when.enabled()),
                not(holds(when.dividesInGuard())));
    }

    /** Two transitions send different things. */
    private T differInOutput(int one, int two) {
        List<T> any = new ArrayList<>();
        for (Port port : subject.component().outputs()) {
            any.add(differ(emission(one, port.name()), emission(two, port.name())));
        }
        return logic.or(any);
    }

    /** What a transition says about a port; null for nothing. */
    private Automaton.@Nullable Emission emission(int transition, String port) {
        for (Send send : transitions().get(transition).sends()) {
            if (send.port().name().equals(port)) {
                return send.emission();
            }
        }
        boolean silent = subject.automaton().omitted() == Automaton.Omitted.SILENT;
        return silent ? new Automaton.Silence() : null;
    }

    private T differ(Automaton.@Nullable Emission one, Automaton.@Nullable Emission two) {
        if (!(one instanceof Messages first) || !(two instanceof Messages second)) {
            boolean same = one == null ? two == null : one.equals(two);
            return logic.of(!same);
        }
        if (first.values().size() != second.values().size()) {
            return logic.of(true);
        }
        List<T> any = new ArrayList<>();
        for (int i = 0; i < first.values().size(); i++) {
            any.add(not(at.areSame(first.values().get(i), second.values().get(i))));
        }
        return logic.or(any);
    }

    /** Two transitions lead to different configurations. */
    private T differInTarget(int one, int two) {
        if (transitions().get(one).target() != transitions().get(two).target()) {
            return logic.of(true);
        }
        List<T> any = new ArrayList<>();
        for (Variable variable : subject.automaton().variables()) {
            boolean stays = assigned(one, variable).isEmpty() && assigned(two, variable).isEmpty();
            any.add(
                    stays
                            ? logic.of(false)
                            : not(at.areSame(after(one, variable), after(two, variable))));
        }
        return logic.or(any);
    }
}
