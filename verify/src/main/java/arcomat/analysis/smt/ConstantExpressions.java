package arcomat.analysis.smt;

import arcomat.analysis.reachability.Subject;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.expression.Interval;
import arcomat.semantics.expression.Scope;

import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.LongStream;

/**
 * The expressions of an automaton that have one value, or few, wherever it is.
 *
 * @param parameters of the component
 * @param arguments one per parameter
 * @param variables of the automaton; others are constants of the component
 */
record ConstantExpressions(
        List<Parameter> parameters, List<Value> arguments, List<Variable> variables)
        implements Expression.SomeCases<Optional<Long>> {
    private static final long FEW = 64;

    /** Where expressions read nothing but ports. */
    static final ConstantExpressions WITHOUT_NAMES =
            new ConstantExpressions(List.of(), List.of(), List.of());

    static ConstantExpressions of(Subject subject) {
        return new ConstantExpressions(
                subject.component().parameters(),
                subject.arguments(),
                subject.automaton().variables());
    }

    /** The argument for a parameter. */
    Value argument(Expression.ParameterRead read) {
        return Scope.ofParameters(parameters, arguments).constant(read);
    }

    /** The value of an integer that is written out, perhaps with a sign or by a name. */
    Optional<Long> integer(Expression e) {
        return e.match(this);
    }

    @Override
    public Optional<Long> constant(Expression.Constant constant) {
        return integer(constant.value());
    }

    @Override
    public Optional<Long> parameterRead(Expression.ParameterRead read) {
        return integer(argument(read));
    }

    @Override
    public Optional<Long> variableRead(Expression.VariableRead read) {
        return isConstant(read.variable()) ? integer(read.variable().initial()) : Optional.empty();
    }

    @Override
    public Optional<Long> unary(Expression.Unary unary) {
        return unary.operator() == Expression.UnaryOperator.NEGATE
                ? integer(unary.operand()).map(value -> -value).filter(fits(unary))
                : Optional.empty();
    }

    @Override
    public Optional<Long> cast(Expression.Cast cast) {
        return Interval.isInteger(cast.type())
                ? integer(cast.operand()).filter(fits(cast))
                : Optional.empty();
    }

    /** What is computed in another way, or read, may be anything. */
    @Override
    public Optional<Long> otherwise(Expression expression) {
        return Optional.empty();
    }

    private static Optional<Long> integer(Value value) {
        return value instanceof Value.IntegerValue integer
                ? Optional.of(integer.value())
                : Optional.empty();
    }

    /** Others wrap around. */
    private static Predicate<Long> fits(Expression e) {
        return value -> Interval.ofWidth(e.type()).turns(BigInteger.valueOf(value)).signum() == 0;
    }

    /** The values of an integer that has one, or a type with few of them; else none. */
    List<Long> few(Expression e) {
        Optional<Long> single = integer(e);
        if (single.isPresent()) {
            return List.of(single.get());
        }
        boolean widens = e instanceof Expression.Cast && !Interval.wraps(e);
        Expression inside = widens ? ((Expression.Cast) e).operand() : e;
        boolean few =
                inside.type() instanceof Type.IntegerType type
                        && type.ranged()
                        && type.high() - type.low() < FEW;
        return few
                ? LongStream.rangeClosed(
                                ((Type.IntegerType) inside.type()).low(),
                                ((Type.IntegerType) inside.type()).high())
                        .boxed()
                        .toList()
                : List.of();
    }

    /** Whether linear arithmetic can say what an operation on whole numbers gives. */
    boolean isLinear(Expression.Binary binary) {
        return switch (binary.operator()) {
            case MULTIPLY -> !few(binary.left()).isEmpty() || !few(binary.right()).isEmpty();
            case DIVIDE, REMAINDER -> !few(binary.right()).isEmpty();
            default -> true;
        };
    }

    /** A constant of the component; variables of the automaton are none. */
    boolean isConstant(Variable variable) {
        return variables.stream().noneMatch(each -> each.name().equals(variable.name()));
    }
}
