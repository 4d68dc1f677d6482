package arcomat.analysis.smt;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Messages;
import arcomat.model.Automaton.Send;
import arcomat.model.Automaton.Transition;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * The transition relation of an automaton at one instant, and what may be shown there, as terms.
 */
final class SymbolicTransitions implements RunProperty.Cases<Term> {
    private final Subject subject;
    private final Instant at;
    private final Solver solver;
    private final Encoding codes;
    private final Translation translation;

    SymbolicTransitions(Subject subject, Instant at, Solver solver, Encoding codes) {
        this.subject = subject;
        this.at = at;
        this.solver = solver;
        this.codes = codes;
        this.translation = new Translation(ConstantExpressions.of(subject), at, solver, codes);
    }

    private List<Transition> transitions() {
        return subject.automaton().transitions();
    }

    private Preconditions preconditions(int transition) {
        return subject.preconditions().get(transition);
    }

    @Override
    public Term reached(RunProperty.Reached reached) {
        return at.isIn(reached.state());
    }

    @Override
    public Term enabled(RunProperty.Enabled enabled) {
        return enabled(enabled.transition());
    }

    @Override
    public Term together(RunProperty.Together together) {
        int one = together.first();
        int two = together.second();
        Term difference =
                switch (together.difference()) {
                    case ANY -> solver.of(true);
                    case OUTPUT ->
                            solver.and(goesWell(one), goesWell(two), differInOutput(one, two));
                    case TARGET ->
                            solver.and(goesWell(one), goesWell(two), differInTarget(one, two));
                };
        return solver.and(enabled(one), enabled(two), difference);
    }

    /** No transition of a state may be taken, and no guard goes wrong. */
    @Override
    public Term unhandled(RunProperty.Unhandled unhandled) {
        Term silent = at.silent();
        return solver.and(
                isUnhandled(unhandled.state()), unhandled.silent() ? silent : solver.not(silent));
    }

    private Term isUnhandled(int state) {
        List<Term> answers = new ArrayList<>();
        for (int i = 0; i < transitions().size(); i++) {
            if (transitions().get(i).source() == state) {
                answers.add(translation.term(preconditions(i).dividesInGuard()));
                answers.add(translation.term(preconditions(i).enabled()));
            }
        }
        return solver.and(at.isIn(state), solver.not(solver.or(answers)));
    }

    @Override
    public Term silenced(RunProperty.Silenced silenced) {
        int transition = silenced.transition();
        return solver.and(
                isUnhandled(transitions().get(transition).source()),
                translation.term(preconditions(transition).enabledButForSilence()));
    }

    /** In the guard, or in the effect where the guard is true; ranges are those of effects. */
    @Override
    public Term wrong(RunProperty.Wrong wrong) {
        int transition = wrong.transition();
        Preconditions when = preconditions(transition);
        return switch (wrong.kind()) {
            case DIVISION_BY_ZERO ->
                    meets(transition, when.dividesInGuard(), when.dividesInEffect());
            case OUTSIDE_RANGE ->
                    solver.and(
                            enabled(transition),
                            solver.not(translation.term(when.dividesInEffect())),
                            leavesRange(transition));
        };
    }

    /** In the guard, or in the effect where the guard is true. */
    @Override
    public Term overflow(RunProperty.Overflow overflow) {
        Preconditions when = preconditions(overflow.transition());
        return meets(overflow.transition(), when.wrapsInGuard(), when.wrapsInEffect());
    }

    private Term meets(int transition, Expression inGuard, Expression inEffect) {
        return solver.or(
                solver.and(
                        at.isIn(transitions().get(transition).source()), translation.term(inGuard)),
                solver.and(enabled(transition), translation.term(inEffect)));
    }

    /** An integer variable is below a bound, or above it. */
    Term beyond(int variable, boolean below, long bound) {
        return solver.apply(below ? "<" : ">", variable(variable), solver.number(bound));
    }

    /** An integer variable is odd, or even. */
    Term parity(int variable, boolean odd) {
        Term rest = solver.apply("mod", variable(variable), solver.number(2));
        return solver.equal(rest, solver.number(odd ? 1 : 0));
    }

    private Term variable(int variable) {
        return at.variable(subject.automaton().variables().get(variable));
    }

    /** It goes to the next instant, and all goes well. */
    Term step(int transition, Instant next) {
        List<Term> all = new ArrayList<>();
        all.add(enabled(transition));
        all.add(goesWell(transition));
        all.add(next.isIn(transitions().get(transition).target()));
        for (Variable variable : subject.automaton().variables()) {
            all.add(solver.equal(next.variable(variable), after(transition, variable)));
        }
        return solver.and(all);
    }

    /** What it sends and assigns has a value that fits. */
    private Term goesWell(int transition) {
        return solver.and(
                solver.not(translation.term(preconditions(transition).dividesInEffect())),
                solver.not(leavesRange(transition)));
    }

    /** What a variable is after a transition. */
    private Term after(int transition, Variable variable) {
        for (Assignment assignment : transitions().get(transition).assignments()) {
            if (assignment.variable().name().equals(variable.name())) {
                return translation.term(assignment.value());
            }
        }
        return at.variable(variable);
    }

    /** It may be taken; its guard does not go wrong. */
    private Term enabled(int transition) {
        Preconditions when = preconditions(transition);
        return solver.and(
                at.isIn(transitions().get(transition).source()),
                translation.term(when.enabled()),
                solver.not(translation.term(when.dividesInGuard())));
    }

    private Term leavesRange(int transition) {
        List<Term> any = new ArrayList<>();
        for (Send send : transitions().get(transition).sends()) {
            send.emission()
                    .values()
                    .forEach(value -> any.add(isOutside(value, send.port().type())));
        }
        for (Assignment assignment : transitions().get(transition).assignments()) {
            any.add(isOutside(assignment.value(), assignment.variable().type()));
        }
        return solver.or(any);
    }

    private Term isOutside(Expression value, Type type) {
        boolean ranged = type instanceof Type.IntegerType integer && integer.ranged();
        return ranged ? solver.not(codes.range(translation.term(value), type)) : solver.of(false);
    }

    /** Two transitions send different things. */
    private Term differInOutput(int one, int two) {
        List<Term> any = new ArrayList<>();
        for (Port port : subject.component().outputs()) {
            any.add(differ(emission(one, port.name()), emission(two, port.name())));
        }
        return solver.or(any);
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

    private Term differ(Automaton.@Nullable Emission one, Automaton.@Nullable Emission two) {
        if (!(one instanceof Messages first) || !(two instanceof Messages second)) {
            boolean same = one == null ? two == null : one.equals(two);
            return solver.of(!same);
        }
        if (first.values().size() != second.values().size()) {
            return solver.of(true);
        }
        List<Term> any = new ArrayList<>();
        for (int i = 0; i < first.values().size(); i++) {
            Expression here = first.values().get(i);
            Term equal =
                    solver.equal(translation.term(here), translation.term(second.values().get(i)));
            any.add(
                    codes.isExact(here.type())
                            ? solver.not(equal)
                            : at.anything(new Type.BooleanType()));
        }
        return solver.or(any);
    }

    /** Two transitions lead to different configurations. */
    private Term differInTarget(int one, int two) {
        if (transitions().get(one).target() != transitions().get(two).target()) {
            return solver.of(true);
        }
        List<Term> any = new ArrayList<>();
        for (Variable variable : subject.automaton().variables()) {
            any.add(solver.not(solver.equal(after(one, variable), after(two, variable))));
        }
        return solver.or(any);
    }
}
