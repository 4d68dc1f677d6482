package arcomat.analysis.automaton;

import static arcomat.analysis.automaton.SmtLib.conjunction;
import static arcomat.analysis.automaton.SmtLib.disjunction;
import static arcomat.analysis.automaton.SmtLib.not;
import static arcomat.analysis.automaton.SmtLib.same;

import arcomat.analysis.automaton.BitVectorTerms.Coded;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.List;

/**
 * An automaton whose inputs are all total, step by step, in the language of SMT-LIB: integers are
 * vectors of bits, doubles are IEEE 754. Shares no code with the analyses.
 */
final class BitVectors {
    private final Component component;
    private final Automaton automaton;
    private final List<Value> arguments;

    BitVectors(Component component, Automaton automaton, List<Value> arguments) {
        this.component = component;
        this.automaton = automaton;
        this.arguments = arguments;
    }

    /** What there is at a step, and of what ranges. */
    List<String> step(int step) {
        List<String> lines = new ArrayList<>();
        lines.add("(declare-const state@" + step + " Int)");
        for (Port port : component.inputs()) {
            declare(BitVectorTerms.port(port.name(), step), port.type(), lines);
        }
        for (Variable variable : automaton.variables()) {
            declare(BitVectorTerms.variable(variable.name(), step), variable.type(), lines);
        }
        return lines;
    }

    private static void declare(String name, Type type, List<String> lines) {
        lines.add("(declare-const " + name + " " + SmtLib.sort(type) + ")");
        if (type instanceof Type.IntegerType integer && integer.ranged()) {
            lines.add("(assert " + SmtLib.isWithin(name, integer) + ")");
        }
    }

    /** Step 0 is a beginning: one initial state, whose variables have their first values. */
    String beginning() {
        List<String> all = new ArrayList<>();
        all.add("(= state@0 " + automaton.initials().get(0).state() + ")");
        for (Variable variable : automaton.variables()) {
            all.add(
                    same(
                            BitVectorTerms.variable(variable.name(), 0),
                            coded(variable.initial(), 0).value()));
        }
        return conjunction(all);
    }

    /** A transition can be taken at a step. */
    String enabled(int index, int step) {
        Coded guard = guard(index, step);
        return conjunction(List.of(isAtSource(index, step), guard.value(), not(guard.wrong())));
    }

    private String isAtSource(int index, int step) {
        return "(= state@" + step + " " + transition(index).source() + ")";
    }

    private Transition transition(int index) {
        return automaton.transitions().get(index);
    }

    /** An integer of a transition wraps around at a step. */
    String wraps(int index, int step) {
        Coded guard = guard(index, step);
        List<String> effects = new ArrayList<>();
        effects(index).forEach(each -> effects.add(coded(each, step).wraps()));
        return disjunction(
                List.of(
                        conjunction(List.of(isAtSource(index, step), guard.wraps())),
                        conjunction(List.of(enabled(index, step), disjunction(effects)))));
    }

    private List<Expression> effects(int index) {
        List<Expression> all = new ArrayList<>();
        for (Automaton.Send send : transition(index).sends()) {
            all.addAll(((Automaton.Messages) send.emission()).values());
        }
        transition(index).assignments().forEach(each -> all.add(each.value()));
        return all;
    }

    /** A transition leads from a step to the next one, and all goes well. */
    String goes(int index, int step) {
        List<String> all = new ArrayList<>();
        all.add(enabled(index, step));
        all.add("(= state@" + (step + 1) + " " + transition(index).target() + ")");
        for (Expression effect : effects(index)) {
            all.add(not(coded(effect, step).wrong()));
        }
        for (Automaton.Send send : transition(index).sends()) {
            for (Expression value : ((Automaton.Messages) send.emission()).values()) {
                all.add(fits(value, send.port().type(), step));
            }
        }
        for (Variable variable : automaton.variables()) {
            String after = BitVectorTerms.variable(variable.name(), step);
            for (Automaton.Assignment assignment : transition(index).assignments()) {
                if (assignment.variable().name().equals(variable.name())) {
                    after = coded(assignment.value(), step).value();
                    all.add(fits(assignment.value(), variable.type(), step));
                }
            }
            all.add(same(BitVectorTerms.variable(variable.name(), step + 1), after));
        }
        return conjunction(all);
    }

    private String fits(Expression value, Type type, int step) {
        return type instanceof Type.IntegerType integer && integer.ranged()
                ? SmtLib.isWithin(coded(value, step).value(), integer)
                : "true";
    }

    private Coded guard(int index, int step) {
        return transition(index)
                .guard()
                .map(guard -> coded(guard, step))
                .orElse(new Coded("true", "false", "false"));
    }

    private Coded coded(Expression e, int step) {
        return new BitVectorTerms(component, arguments, step).of(e);
    }
}
