package arcomat.analysis.automaton.induction;

import arcomat.analysis.reachability.Bounds;
import arcomat.analysis.reachability.Hazard;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.Interval;
import arcomat.semantics.expression.Replacement;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * Conditions over the variables of which some may always be so in a state: what guards ask, and
 * comparisons with numbers that are mentioned somewhere.
 */
public final class CandidateConditions {
    private static final int MOST_ATOMS = 40;
    private static final int MOST_NUMBERS = 10;
    private static final int MOST_PAIRED = 5;

    private final Subject subject;
    private final List<Move> moves;

    public CandidateConditions(Subject subject, List<Move> moves) {
        this.subject = subject;
        this.moves = moves;
    }

    /** What guards and effects ask of the variables alone, and the contrary. */
    public List<Expression> asked() {
        Set<Expression> atoms = new LinkedHashSet<>();
        for (Move move : moves) {
            collect(move.goesOn(), atoms);
            collect(move.escapes(), atoms);
        }
        for (Expression atom : List.copyOf(atoms)) {
            moves.forEach(move -> before(move, atom).ifPresent(atoms::add));
        }
        Set<Expression> both = new LinkedHashSet<>();
        atoms.stream()
                .limit(MOST_ATOMS)
                .forEach(
                        atom -> {
                            both.add(atom);
                            both.add(Formulas.not(atom));
                        });
        both.addAll(limits());
        return List.copyOf(both);
    }

    /** What has to be so for a condition to be so after a transition, whatever is read. */
    private static Optional<Expression> before(Move move, Expression after) {
        return Optional.of(Replacement.ofVariables(move.assigned()).of(after))
                .filter(before -> !before.equals(after) && isAboutVariables(before));
    }

    /** When no message is above a term or below it, or between two. */
    private Set<Expression> limits() {
        Set<Expression> limits = new LinkedHashSet<>();
        for (Move move : moves) {
            for (Port port : subject.component().inputs()) {
                if (port.type() instanceof Type.IntegerType type) {
                    limits(terms(move, port), type, limits);
                }
            }
        }
        return limits;
    }

    private static List<Expression> terms(Move move, Port port) {
        return new Isolation(port)
                .terms(move.goesOn()).stream()
                        .filter(each -> each.ports().isEmpty() && Interval.isInteger(each.type()))
                        .map(Replacement.ofVariables(Map.of())::of)
                        .distinct()
                        .toList();
    }

    private static void limits(
            List<Expression> terms, Type.IntegerType type, Set<Expression> limits) {
        for (Expression term : terms) {
            if (term instanceof Expression.Constant) {
                continue;
            }
            limits.add(
                    Hazard.compare(
                            BinaryOperator.LESS_OR_EQUAL, term, Hazard.number(type.low(), term)));
            limits.add(
                    Hazard.compare(
                            BinaryOperator.GREATER_OR_EQUAL,
                            term,
                            Hazard.number(type.high(), term)));
            for (Expression other : terms) {
                if (term != other && term.type().equals(other.type())) {
                    limits.add(Hazard.compare(BinaryOperator.LESS, term, other));
                    limits.add(Hazard.compare(BinaryOperator.LESS_OR_EQUAL, term, other));
                    limits.add(Hazard.compare(BinaryOperator.GREATER, term, other));
                    limits.add(Hazard.compare(BinaryOperator.GREATER_OR_EQUAL, term, other));
                }
            }
        }
    }

    /** Not taken apart further than to what is not made of truth values. */
    private static void collect(Expression e, Set<Expression> atoms) {
        if (isTruth(e) && !isConnective(e) && isAboutVariables(e)) {
            atoms.add(e);
        } else {
            e.operands().forEach(each -> collect(each, atoms));
        }
    }

    private static boolean isConnective(Expression e) {
        return !e.operands().isEmpty()
                && e.operands().stream().allMatch(CandidateConditions::isTruth);
    }

    private static boolean isTruth(Expression e) {
        return e.type() instanceof Type.BooleanType;
    }

    private static boolean isAboutVariables(Expression e) {
        return e.ports().isEmpty() && e.contains(Expression.VariableRead.class::isInstance);
    }

    /** And comparisons with each other, and with what is mentioned. */
    public List<Expression> all() {
        Set<Expression> all = new LinkedHashSet<>(asked());
        Bounds.candidates(subject).forEach(each -> all.add(Formulas.not(each)));
        List<Variable> variables = subject.automaton().variables();
        for (Variable each : variables) {
            mentioned(each).forEach(value -> all.addAll(compared(each, value)));
        }
        if (variables.size() <= MOST_PAIRED) {
            pairs(variables, all);
        }
        return List.copyOf(all);
    }

    private static void pairs(List<Variable> variables, Set<Expression> all) {
        for (Variable one : variables) {
            for (Variable other : variables) {
                if (!one.equals(other)
                        && one.type().isNumber()
                        && one.type().equals(other.type())) {
                    all.add(Hazard.compare(BinaryOperator.LESS_OR_EQUAL, read(one), read(other)));
                }
            }
        }
    }

    private Set<Value> mentioned(Variable variable) {
        Set<Value> values = new LinkedHashSet<>();
        int slot = subject.automaton().variables().indexOf(variable);
        subject.relation()
                .starts()
                .forEach(each -> values.add(each.configuration().variables().get(slot)));
        Set<Value> constants = new TreeSet<>();
        for (Move move : moves) {
            collectValues(move.goesOn(), variable.type(), constants);
            collectValues(move.escapes(), variable.type(), constants);
            move.assigned().values().forEach(e -> collectValues(e, variable.type(), constants));
        }
        constants.stream().limit(MOST_NUMBERS).forEach(values::add);
        return values;
    }

    private static void collectValues(Expression e, Type type, Set<Value> values) {
        e.visit(
                part -> {
                    if (part instanceof Expression.Constant constant
                            && !(type instanceof Type.ClassType)
                            && type.has(constant.value())) {
                        values.add(constant.value());
                    }
                });
    }

    /** What a value may be compared with a variable for. */
    private static List<Expression> compared(Variable variable, Value value) {
        Expression read = read(variable);
        Expression constant = new Expression.Constant(value, variable.type(), variable.span());
        if (variable.type() instanceof Type.ClassType) {
            return List.of();
        }
        if (variable.type() instanceof Type.RealType) {
            // Neither is so of what is no number, and then both are denied.
            return List.of(
                    Hazard.compare(BinaryOperator.GREATER_OR_EQUAL, read, constant),
                    Hazard.compare(BinaryOperator.LESS_OR_EQUAL, read, constant),
                    Formulas.not(Hazard.compare(BinaryOperator.LESS, read, constant)),
                    Formulas.not(Hazard.compare(BinaryOperator.GREATER, read, constant)));
        }
        return variable.type().isNumber()
                ? List.of(
                        Hazard.compare(BinaryOperator.GREATER_OR_EQUAL, read, constant),
                        Hazard.compare(BinaryOperator.LESS_OR_EQUAL, read, constant))
                : List.of(
                        Hazard.compare(BinaryOperator.EQUAL, read, constant),
                        Hazard.compare(BinaryOperator.NOT_EQUAL, read, constant));
    }

    /** That variables are not beyond their present values; what is no number stays none. */
    public List<Expression> near(List<Value> present) {
        List<Expression> near = new ArrayList<>();
        List<Variable> variables = subject.automaton().variables();
        for (int i = 0; i < present.size(); i++) {
            near.addAll(compared(variables.get(i), present.get(i)));
            if (variables.get(i).type() instanceof Type.RealType) {
                Expression read = read(variables.get(i));
                near.add(Hazard.compare(BinaryOperator.NOT_EQUAL, read, read));
            }
        }
        return near;
    }

    private static Expression read(Variable variable) {
        return new Expression.VariableRead(variable, variable.span());
    }
}
