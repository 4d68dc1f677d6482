package arcomat.semantics.expression;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Valuation;
import arcomat.model.Value;
import arcomat.rt.Kleene;

import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * Makes expressions ready to run. Boolean connectives follow Kleene: undefined, unless the defined
 * operand decides. Everything else is undefined when an operand is.
 */
public final class Evaluation implements Expression.Cases<Term> {
    private static final Value TRUE = new Value.BooleanValue(true);
    private static final Value FALSE = new Value.BooleanValue(false);

    private final Scope scope;

    private Evaluation(Scope scope) {
        this.scope = scope;
    }

    public static Term compile(Expression expression, Scope scope) {
        return new Evaluation(scope).term(expression);
    }

    private static Value truth(boolean value) {
        return value ? TRUE : FALSE;
    }

    private static boolean isTrue(@Nullable Value value) {
        return value != null && ((Value.BooleanValue) value).value();
    }

    private static boolean isFalse(@Nullable Value value) {
        return value != null && !((Value.BooleanValue) value).value();
    }

    private Term term(Expression e) {
        return e.match(this);
    }

    @Override
    public Term constant(Expression.Constant constant) {
        Value value = constant.value();
        return (ports, variables) -> value;
    }

    @Override
    public Term portRead(Expression.PortRead read) {
        int port = scope.port(read.port());
        return (ports, variables) -> ports[port];
    }

    @Override
    public Term variableRead(Expression.VariableRead read) {
        int slot = scope.variable(read.variable());
        if (slot >= 0) {
            return (ports, variables) -> variables[slot];
        }
        Value value = scope.constantOf(read.variable());
        return (ports, variables) -> value;
    }

    @Override
    public Term parameterRead(Expression.ParameterRead read) {
        Value value = scope.parameter(read.parameter());
        return (ports, variables) -> value;
    }

    @Override
    public Term attributeRead(Expression.AttributeRead read) {
        Term object = term(read.object());
        return (ports, variables) -> {
            Value value = object.evaluate(ports, variables);
            return value == null
                    ? null
                    : ((Value.ObjectValue) value).attributes().get(read.index());
        };
    }

    @Override
    public Term portMatches(Expression.PortMatches matches) {
        int port = scope.port(matches.port());
        return matches.pattern()
                .match(
                        oneOf -> isOneOf(port, oneOf.values().stream().map(this::term).toList()),
                        () -> (ports, variables) -> truth(ports[port] == null),
                        () -> (ports, variables) -> truth(ports[port] != null));
    }

    private static Term isOneOf(int port, List<Term> values) {
        if (values.size() == 1) {
            Term value = values.get(0);
            return (ports, variables) ->
                    truth(ports[port] != null && equals(ports[port], value, ports, variables));
        }
        return (ports, variables) -> truth(isAmong(ports[port], values, ports, variables));
    }

    private static boolean equals(Value found, Term asked, Value[] ports, Value[] variables) {
        Value value = asked.evaluate(ports, variables);
        return value != null && Arithmetic.equal(found, value);
    }

    private static boolean isAmong(
            @Nullable Value found, List<Term> values, Value[] ports, Value[] variables) {
        if (found != null) {
            for (Term value : values) {
                if (equals(found, value, ports, variables)) {
                    return true;
                }
            }
        }
        return false;
    }

    @Override
    public Term unary(Expression.Unary unary) {
        Term operand = term(unary.operand());
        return (ports, variables) -> {
            Value value = operand.evaluate(ports, variables);
            if (value == null) {
                return null;
            }
            return switch (unary.operator()) {
                case NOT -> truth(isFalse(value));
                case NEGATE -> Arithmetic.negate(value, unary.type());
                case COMPLEMENT -> Arithmetic.complement(value);
            };
        };
    }

    @Override
    public Term conditional(Expression.Conditional choice) {
        Term condition = term(choice.condition());
        Term then = term(choice.then());
        Term otherwise = term(choice.otherwise());
        return (ports, variables) -> {
            Value value = condition.evaluate(ports, variables);
            if (value == null) {
                return null;
            }
            return (isTrue(value) ? then : otherwise).evaluate(ports, variables);
        };
    }

    @Override
    public Term isIn(Expression.IsIn isIn) {
        Term element = term(isIn.element());
        List<Term> set = isIn.set().stream().map(this::term).toList();
        return (ports, variables) -> {
            Value found = element.evaluate(ports, variables);
            return found == null ? null : isIn(found, set, ports, variables);
        };
    }

    /** Behind the value that is found nothing is computed, but all messages have to be there. */
    private static @Nullable Value isIn(
            Value found, List<Term> set, Value[] ports, Value[] variables) {
        boolean contained = false;
        for (Term term : set) {
            if (contained) {
                if (!isDefined(term, ports, variables)) {
                    return null;
                }
            } else {
                Value value = term.evaluate(ports, variables);
                if (value == null) {
                    return null;
                }
                contained = Arithmetic.equal(found, value);
            }
        }
        return truth(contained);
    }

    private static boolean isDefined(Term term, Value[] ports, Value[] variables) {
        try {
            return term.evaluate(ports, variables) != null;
        } catch (Fault fault) {
            return true;
        }
    }

    @Override
    public Term cast(Expression.Cast cast) {
        Term operand = term(cast.operand());
        return (ports, variables) -> {
            Value value = operand.evaluate(ports, variables);
            return value == null ? null : Arithmetic.cast(value, cast.type());
        };
    }

    @Override
    public Term binary(Expression.Binary binary) {
        Term left = term(binary.left());
        Term right = term(binary.right());
        return switch (binary.operator()) {
            case AND -> (ports, variables) -> and(left, right, ports, variables);
            case OR -> (ports, variables) -> or(left, right, ports, variables);
            case IMPLIES ->
                    (ports, variables) -> {
                        Term negated = (p, v) -> negation(left.evaluate(p, v));
                        return or(negated, right, ports, variables);
                    };
            default -> strict(binary, left, right);
        };
    }

    private static @Nullable Value negation(@Nullable Value value) {
        return value == null ? null : truth(isFalse(value));
    }

    private static @Nullable Value and(Term left, Term right, Value[] ports, Value[] variables) {
        Value first = left.evaluate(ports, variables);
        if (isFalse(first)) {
            return FALSE;
        }
        Value second = right.evaluate(ports, variables);
        return isFalse(second) ? FALSE : first == null ? null : second;
    }

    private static @Nullable Value or(Term left, Term right, Value[] ports, Value[] variables) {
        Value first = left.evaluate(ports, variables);
        if (isTrue(first)) {
            return TRUE;
        }
        Value second = right.evaluate(ports, variables);
        return isTrue(second) ? TRUE : first == null ? null : second;
    }

    private static Term strict(Expression.Binary binary, Term left, Term right) {
        return (ports, variables) -> {
            Value first = left.evaluate(ports, variables);
            Value second = right.evaluate(ports, variables);
            return first == null || second == null ? null : apply(binary, first, second);
        };
    }

    private static Value apply(Expression.Binary binary, Value left, Value right) {
        BinaryOperator operator = binary.operator();
        return switch (operator) {
            case EQUAL, EQUIVALENT -> truth(Arithmetic.equal(left, right));
            case NOT_EQUAL -> truth(!Arithmetic.equal(left, right));
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL ->
                    truth(Arithmetic.compare(operator, left, right));
            case PLUS -> plus(binary, left, right);
            case MULTIPLY, DIVIDE, REMAINDER, MINUS ->
                    Arithmetic.calculate(operator, left, right, binary.type());
            case AND, OR, IMPLIES -> throw new AssertionError(operator);
        };
    }

    private static Value plus(Expression.Binary binary, Value left, Value right) {
        if (binary.type() instanceof Type.StringType) {
            return new Value.StringValue(
                    Arithmetic.text(left, binary.left().type())
                            + Arithmetic.text(right, binary.right().type()));
        }
        return Arithmetic.calculate(BinaryOperator.PLUS, left, right, binary.type());
    }

    @Override
    public Term judged(Expression.Judged judged) {
        Knowledge all = judged.valuation().fold(new Judging());
        return (ports, variables) -> {
            int known = all.in(ports, variables);
            if (Kleene.isWrong(known)) {
                throw Fault.divisionByZero();
            }
            return truth(Kleene.isTrue(known, ""));
        };
    }

    /** What is known of a condition, as {@link Kleene} counts it. */
    @FunctionalInterface
    private interface Knowledge {
        int in(Value[] ports, Value[] variables);
    }

    private final class Judging implements Valuation.Cases<Knowledge> {
        @Override
        public Knowledge part(Valuation.Part part) {
            Term defined = term(part.defined());
            Term value = term(part.value());
            Knowledge known = tried((p, v) -> Kleene.of(value.holds(p, v)), Kleene.DEFINED_WRONG);
            return tried(
                    (p, v) -> defined.holds(p, v) ? known.in(p, v) : Kleene.UNDEFINED,
                    Kleene.WRONG);
        }

        private static Knowledge tried(Knowledge knowledge, int wrong) {
            return (ports, variables) -> {
                try {
                    return knowledge.in(ports, variables);
                } catch (Fault divisionByZero) {
                    return wrong;
                }
            };
        }

        @Override
        public Knowledge not(Knowledge operand) {
            return (ports, variables) -> Kleene.not(operand.in(ports, variables));
        }

        @Override
        public Knowledge row(boolean all, Knowledge left, Knowledge right) {
            return all
                    ? (p, v) -> Kleene.and(left.in(p, v), right.in(p, v))
                    : (p, v) -> Kleene.or(left.in(p, v), right.in(p, v));
        }

        @Override
        public Knowledge comparison(boolean equal, Knowledge left, Knowledge right) {
            Knowledge same = (p, v) -> Kleene.equal(left.in(p, v), right.in(p, v));
            return equal ? same : not(same);
        }

        @Override
        public Knowledge choice(Knowledge condition, Knowledge then, Knowledge otherwise) {
            return (p, v) -> Kleene.choose(condition.in(p, v), then.in(p, v), otherwise.in(p, v));
        }
    }
}
