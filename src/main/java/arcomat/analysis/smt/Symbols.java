package arcomat.analysis.smt;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Parameter;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;

/** Which names of an automaton stand for fixed values. */
record Symbols(Component component, Automaton automaton, List<Value> arguments) {
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
            return integer(unary.operand()).map(value -> -value);
        }
        if (e instanceof Expression.Cast cast && Translation.isInteger(cast.type())) {
            return integer(cast.operand());
        }
        if (e instanceof Expression.VariableRead read && isConstant(read.variable())) {
            return integer(read.variable().initial());
        }
        return fixed(e).filter(Value.IntegerValue.class::isInstance)
                .map(value -> ((Value.IntegerValue) value).value());
    }

    /** The values of an integer that has one, or a type with few of them; else none. */
    List<Long> few(Expression e) {
        Optional<Long> single = integer(e);
        if (single.isPresent()) {
            return List.of(single.get());
        }
        Expression inside = e instanceof Expression.Cast cast ? cast.operand() : e;
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
