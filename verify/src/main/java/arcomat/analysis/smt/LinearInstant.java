package arcomat.analysis.smt;

import arcomat.analysis.reachability.Instant;
import arcomat.analysis.reachability.Reachability;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.ArrayList;
import java.util.List;

/** Where an automaton is at one point of a run, in linear arithmetic. */
final class LinearInstant implements Instant<Term>, ReadTerms {
    private final Subject subject;
    private final Component component;
    private final Solver solver;
    private final Encoding codes;
    private final Translation translation;
    private final int number;
    private final Runnable inexact;
    private int unknowns;
    private int definitions;

    /**
     * @param number from 0
     * @param inexact told where something may be anything
     */
    LinearInstant(Subject subject, Solver solver, Encoding codes, int number, Runnable inexact) {
        this.subject = subject;
        this.component = subject.component();
        this.solver = solver;
        this.codes = codes;
        this.translation = new Translation(ConstantExpressions.of(subject), this, solver, codes);
        this.number = number;
        this.inexact = inexact;
    }

    private Term state() {
        return solver.integer("state@" + number);
    }

    @Override
    public Term isIn(int state) {
        return solver.equal(state(), solver.number(state));
    }

    @Override
    public Term value(Expression e) {
        return translation.term(e);
    }

    /** That holds of objects, too: each has a number, whichever that is. */
    @Override
    public Term areSame(Expression one, Expression other) {
        return solver.equal(value(one), value(other));
    }

    @Override
    public Term is(Variable variable, Value value) {
        if (!codes.isExact(variable.type())) {
            inexact.run();
            return solver.of(true);
        }
        return solver.equal(variable(variable), codes.encode(value, variable.type()));
    }

    @Override
    public Term is(Variable variable, Expression value, Instant<Term> there) {
        return solver.equal(variable(variable), there.value(value));
    }

    @Override
    public Term variable(Variable variable) {
        return unknown("var " + variable.name() + "@" + number, variable.type());
    }

    @Override
    public Term message(Port port) {
        return unknown("port " + port.name() + "@" + number, port.type());
    }

    @Override
    public Term has(Port port) {
        return subject.isAlwaysThere(port)
                ? solver.of(true)
                : solver.truth("has " + port.name() + "@" + number);
    }

    /** A value that is not modelled: it may be any of its type. */
    @Override
    public Term anything(Type type) {
        inexact.run();
        Term unknown = unknown("any " + unknowns++ + "@" + number, type);
        solver.claim(codes.range(unknown, type));
        return unknown;
    }

    /** A number that claims will define. */
    @Override
    public Term defined() {
        return solver.integer("value " + definitions++ + "@" + number);
    }

    private Term unknown(String name, Type type) {
        return Encoding.isTruth(type) ? solver.truth(name) : solver.integer(name);
    }

    @Override
    public Term isWellTyped() {
        List<Term> all = new ArrayList<>();
        all.add(solver.between(0, state(), subject.automaton().states().size() - 1));
        for (Variable each : subject.automaton().variables()) {
            all.add(codes.range(variable(each), each.type()));
        }
        for (Port each : component.inputs()) {
            all.add(codes.range(message(each), each.type()));
            has(each); // is known to the solver before it is asked
        }
        return solver.and(all);
    }

    @Override
    public Reachability.Place place() {
        List<Value> values = new ArrayList<>();
        for (Variable each : subject.automaton().variables()) {
            values.add(codes.decode(variable(each), each.type()));
        }
        return new Reachability.Place(solver.numberOf(state()).intValue(), values);
    }

    @Override
    public Value[] letter() {
        List<Port> inputs = component.inputs();
        Value[] letter = new Value[inputs.size()];
        for (int i = 0; i < letter.length; i++) {
            if (solver.truthOf(has(inputs.get(i)))) {
                letter[i] = codes.decode(message(inputs.get(i)), inputs.get(i).type());
            }
        }
        return letter;
    }
}
