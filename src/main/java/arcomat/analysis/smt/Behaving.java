package arcomat.analysis.smt;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Automaton.Messages;
import arcomat.model.Automaton.Send;
import arcomat.model.Automaton.Transition;
import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Variable;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** What the transitions do at one instant. */
final class Behaving {
    private final Symbols symbols;
    private final Instant at;
    private final Solver solver;
    private final Translation translation;
    private final Hazards hazards;

    Behaving(Symbols symbols, Instant at, Solver solver, Codes codes) {
        this.symbols = symbols;
        this.at = at;
        this.solver = solver;
        this.translation = new Translation(symbols, at, solver, codes);
        this.hazards = new Hazards(translation, solver);
    }

    private List<Transition> transitions() {
        return symbols.automaton().transitions();
    }

    private Condition condition(int transition) {
        return symbols.conditions().get(transition);
    }

    /** It goes to the next instant, and all goes well. */
    Term step(int transition, Instant next) {
        Transition move = transitions().get(transition);
        List<Term> all = new ArrayList<>();
        all.add(enabled(transition));
        all.add(goesWell(transition));
        all.add(next.isIn(move.target()));
        for (Variable variable : symbols.automaton().variables()) {
            all.add(solver.equal(next.variable(variable), after(transition, variable)));
        }
        return solver.and(all);
    }

    /** What it sends and assigns has a value that fits. */
    Term goesWell(int transition) {
        return solver.and(
                solver.not(effectIs(transition, hazards::divisionByZero)),
                solver.not(leavesRange(transition)));
    }

    /** What a variable is after a transition. */
    Term after(int transition, Variable variable) {
        for (Assignment assignment : transitions().get(transition).assignments()) {
            if (assignment.variable().name().equals(variable.name())) {
                return translation.term(assignment.value());
            }
        }
        return at.variable(variable);
    }

    /** It may be taken; its guard does not go wrong. */
    Term enabled(int transition) {
        int state = transitions().get(transition).source();
        return solver.and(
                at.isIn(state), guard(transition), solver.not(guardGoesWrong(transition)));
    }

    private Term guard(int transition) {
        return translation.term(condition(transition).enabled());
    }

    private Term guardGoesWrong(int transition) {
        return hazards.divisionByZero(condition(transition).enabled());
    }

    /** No transition of a state may be taken, and no guard goes wrong. */
    Term nothingEnabled(int state) {
        List<Term> answers = new ArrayList<>();
        for (int i = 0; i < transitions().size(); i++) {
            if (transitions().get(i).source() == state) {
                answers.add(guardGoesWrong(i));
                answers.add(guard(i));
            }
        }
        return solver.and(at.isIn(state), solver.not(solver.or(answers)));
    }

    /** A division by zero in the guard, or in the effect where the guard is true. */
    Term dividesByZero(int transition) {
        return meets(
                transition,
                guardGoesWrong(transition),
                effectIs(transition, hazards::divisionByZero));
    }

    /** An integer that wraps around in the guard, or in the effect where the guard is true. */
    Term overflows(int transition) {
        return meets(
                transition,
                translation.term(condition(transition).wrapsInGuard()),
                translation.term(condition(transition).wrapsInEffect()));
    }

    private Term meets(int transition, Term inGuard, Term inEffect) {
        return solver.or(
                solver.and(at.isIn(transitions().get(transition).source()), inGuard),
                solver.and(enabled(transition), inEffect));
    }

    /** It may be taken, and a value is outside of its range. */
    Term overflowsRange(int transition) {
        return solver.and(
                enabled(transition),
                solver.not(effectIs(transition, hazards::divisionByZero)),
                leavesRange(transition));
    }

    private Term effectIs(int transition, Function<Expression, Term> hazard) {
        return solver.or(
                Condition.effects(transitions().get(transition)).stream().map(hazard).toList());
    }

    private static List<Expression> values(Send send) {
        return send.emission() instanceof Messages messages ? messages.values() : List.of();
    }

    private Term leavesRange(int transition) {
        List<Term> any = new ArrayList<>();
        for (Send send : transitions().get(transition).sends()) {
            values(send).forEach(value -> any.add(isOutside(value, send.port().type())));
        }
        for (Assignment assignment : transitions().get(transition).assignments()) {
            any.add(isOutside(assignment.value(), assignment.variable().type()));
        }
        return solver.or(any);
    }

    private Term isOutside(Expression value, Type type) {
        boolean ranged = type instanceof Type.IntegerType integer && integer.ranged();
        return ranged
                ? solver.not(Codes.range(translation.term(value), type, solver))
                : solver.of(false);
    }

    /** Two transitions send different things. */
    Term differInOutput(int one, int two) {
        List<Term> any = new ArrayList<>();
        symbols.component()
                .outputs()
                .forEach(
                        port ->
                                any.add(
                                        differ(
                                                emission(one, port.name()),
                                                emission(two, port.name()))));
        return solver.or(any);
    }

    /** What a transition says about a port; null for nothing. */
    private Automaton.Emission emission(int transition, String port) {
        for (Send send : transitions().get(transition).sends()) {
            if (send.port().name().equals(port)) {
                return send.emission();
            }
        }
        boolean silent = symbols.automaton().omitted() == Automaton.Omitted.SILENT;
        return silent ? new Automaton.Silence() : null;
    }

    private Term differ(Automaton.Emission one, Automaton.Emission two) {
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
            any.add(Codes.isExact(here.type()) ? solver.not(equal) : at.anything(TRUTH));
        }
        return solver.or(any);
    }

    private static final Type TRUTH = new Type.BooleanType();

    /** Two transitions lead to different configurations. */
    Term differInTarget(int one, int two) {
        if (transitions().get(one).target() != transitions().get(two).target()) {
            return solver.of(true);
        }
        List<Term> any = new ArrayList<>();
        for (Variable variable : symbols.automaton().variables()) {
            any.add(solver.not(solver.equal(after(one, variable), after(two, variable))));
        }
        return solver.or(any);
    }
}
