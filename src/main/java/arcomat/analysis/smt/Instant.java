package arcomat.analysis.smt;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.util.ArrayList;
import java.util.List;

/** Where an automaton is at one point of a run, and what it reads there. */
final class Instant implements ReadTerms {
    private final Subject subject;
    private final Component component;
    private final Solver solver;
    private final Encoding codes;
    private final int number;
    private int unknowns;
    private int definitions;

    /**
     * @param number from 0
     */
    Instant(Subject subject, Solver solver, Encoding codes, int number) {
        this.subject = subject;
        this.component = subject.component();
        this.solver = solver;
        this.codes = codes;
        this.number = number;
    }

    Term state() {
        return solver.integer("state@" + number);
    }

    Term isIn(int state) {
        return solver.equal(state(), solver.number(state));
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
        boolean timed = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        return timed && port.total() || port.first().isPresent()
                ? solver.of(true)
                : solver.truth("has " + port.name() + "@" + number);
    }

    /** A value that is not modelled: it may be any of its type. */
    @Override
    public Term anything(Type type) {
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

    /** What always holds: values are of their types, and events come one by one. */
    Term wellFormed() {
        List<Term> all = new ArrayList<>();
        all.add(solver.between(0, state(), subject.automaton().states().size() - 1));
        for (Variable each : subject.automaton().variables()) {
            all.add(codes.range(variable(each), each.type()));
        }
        for (Port each : component.inputs()) {
            all.add(codes.range(message(each), each.type()));
            has(each); // is known to the solver before it is asked
        }
        if (component.profile() == Component.Profile.EVENT_DRIVEN) {
            all.add(oneEvent());
        }
        return solver.and(all);
    }

    private Term oneEvent() {
        List<Term> one = new ArrayList<>();
        List<Port> events = component.inputs().stream().filter(port -> !port.latched()).toList();
        for (Port here : events) {
            List<Term> alone = new ArrayList<>();
            for (Port port : events) {
                alone.add(port.equals(here) ? has(port) : solver.not(has(port)));
            }
            one.add(solver.and(alone));
        }
        return solver.or(one);
    }

    /** Latched ports do not lose their message until then. */
    Term keepsLatched(Instant next) {
        List<Term> kept = new ArrayList<>();
        for (Port port : component.inputs()) {
            if (component.profile() == Component.Profile.EVENT_DRIVEN && port.latched()) {
                kept.add(solver.or(solver.not(has(port)), next.has(port)));
            }
        }
        return solver.and(kept);
    }

    /** No port carries a message. */
    Term silent() {
        List<Term> all = new ArrayList<>();
        component.inputs().forEach(port -> all.add(solver.not(has(port))));
        return solver.and(all);
    }

    /** After the answer yes: the example's configuration. */
    Reachability.Place place() {
        List<Value> values = new ArrayList<>();
        for (Variable each : subject.automaton().variables()) {
            values.add(codes.decode(variable(each), each.type()));
        }
        return new Reachability.Place(solver.numberOf(state()).intValue(), values);
    }

    /** After the answer yes: what the example reads. */
    Value[] letter() {
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
