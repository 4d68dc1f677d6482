package arcomat.analysis.smt;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.expression.Interval;

import java.math.BigInteger;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.LongStream;

/** Which names of an automaton stand for fixed values, and when its transitions may be taken. */
record Symbols(
        Component component,
        Automaton automaton,
        List<Value> arguments,
        List<Condition> conditions) {
    private static final long FEW = 64;

    /** The value of a constant or a parameter. */
    Optional<Value> fixed(Expression e) {
        if (e instanceof Expression.Constant constant) {
            return Optional.of(constant.value());
        }
        if (e instanceof Expression.ParameterRead read) {
            List<Parameter> parameters = component.parameters();
            for (int i = 0; i < parameters.size(); i++) {
                if (parameters.get(i).name().equals(read.parameter().name())) {
                    return Optional.of(arguments.get(i));
                }
            }
        }
        return Optional.empty();
    }

    /** The value of an integer that is written out, perhaps with a sign or by a name. */
    Optional<Long> integer(Expression e) {
        if (e instanceof Expression.Unary unary
                && unary.operator() == Expression.UnaryOperator.NEGATE) {
            return integer(unary.operand()).map(value -> -value).filter(fits(e));
        }
        if (e instanceof Expression.Cast cast && Translation.isInteger(cast.type())) {
            return integer(cast.operand()).filter(fits(e));
        }
        if (e instanceof Expression.VariableRead read && isConstant(read.variable())) {
            return integer(read.variable().initial());
        }
        return fixed(e).filter(Value.IntegerValue.class::isInstance)
                .map(value -> ((Value.IntegerValue) value).value());
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

    /** A constant of the component; variables of the automaton are none. */
    boolean isConstant(Variable variable) {
        return automaton.variables().stream()
                .noneMatch(each -> each.name().equals(variable.name()));
    }
}
