package arcomat.analysis.automaton;

import static arcomat.analysis.automaton.SmtLib.conjunction;
import static arcomat.analysis.automaton.SmtLib.disjunction;
import static arcomat.analysis.automaton.SmtLib.not;
import static arcomat.analysis.automaton.SmtLib.same;

import arcomat.analysis.automaton.BitVectorTerms.Coded;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/** Expressions at one step of a run; those that the random automata are made of. */
record BitVectorTerms(Component component, List<Value> arguments, int step)
        implements Expression.Cases<Coded> {

    /**
     * An expression at one step.
     *
     * @param wrong when its evaluation divides by zero
     * @param wraps when it meets an integer that wraps around
     */
    record Coded(String value, String wrong, String wraps) {}

    Coded of(Expression e) {
        return e.match(this);
    }

    static String port(String name, int step) {
        return "p." + name + "@" + step;
    }

    static String variable(String name, int step) {
        return "v." + name + "@" + step;
    }

    private static Coded plain(String value) {
        return new Coded(value, "false", "false");
    }

    @Override
    public Coded constant(Expression.Constant constant) {
        return plain(SmtLib.literal(constant.value(), constant.type()));
    }

    @Override
    public Coded portRead(Expression.PortRead read) {
        return plain(port(read.port().name(), step));
    }

    @Override
    public Coded variableRead(Expression.VariableRead read) {
        return plain(variable(read.variable().name(), step));
    }

    @Override
    public Coded parameterRead(Expression.ParameterRead read) {
        return plain(SmtLib.literal(arguments.get(position(read)), read.type()));
    }

    private int position(Expression.ParameterRead read) {
        for (int i = 0; i < component.parameters().size(); i++) {
            if (component.parameters().get(i).name().equals(read.parameter().name())) {
                return i;
            }
        }
        throw new AssertionError(read);
    }

    @Override
    public Coded attributeRead(Expression.AttributeRead read) {
        throw new AssertionError(read);
    }

    @Override
    public Coded portMatches(Expression.PortMatches matches) {
        throw new AssertionError(matches);
    }

    @Override
    public Coded isIn(Expression.IsIn isIn) {
        throw new AssertionError(isIn);
    }

    @Override
    public Coded unary(Expression.Unary unary) {
        Coded operand = of(unary.operand());
        return switch (unary.operator()) {
            case NOT -> new Coded(not(operand.value), operand.wrong, operand.wraps);
            case COMPLEMENT ->
                    new Coded("(bvnot " + operand.value + ")", operand.wrong, operand.wraps);
            case NEGATE -> {
                if (unary.type() instanceof Type.RealType) {
                    yield new Coded("(fp.neg " + operand.value + ")", operand.wrong, operand.wraps);
                }
                int bits = SmtLib.bits(unary.type());
                String least = SmtLib.vector(BigInteger.ONE.shiftLeft(bits - 1), bits);
                yield new Coded(
                        "(bvneg " + operand.value + ")",
                        operand.wrong,
                        disjunction(List.of(operand.wraps, same(operand.value, least))));
            }
        };
    }

    @Override
    public Coded binary(Expression.Binary binary) {
        Coded left = of(binary.left());
        Coded right = of(binary.right());
        BinaryOperator operator = binary.operator();
        if (operator == BinaryOperator.AND
                || operator == BinaryOperator.OR
                || operator == BinaryOperator.IMPLIES) {
            String goesOn = operator == BinaryOperator.OR ? not(left.value) : left.value;
            String value =
                    switch (operator) {
                        case AND -> conjunction(List.of(left.value, right.value));
                        case OR -> disjunction(List.of(left.value, right.value));
                        default -> disjunction(List.of(not(left.value), right.value));
                    };
            return new Coded(
                    value,
                    disjunction(List.of(left.wrong, conjunction(List.of(goesOn, right.wrong)))),
                    disjunction(List.of(left.wraps, conjunction(List.of(goesOn, right.wraps)))));
        }
        List<String> wrong = new ArrayList<>(List.of(left.wrong, right.wrong));
        List<String> wraps = new ArrayList<>(List.of(left.wraps, right.wraps));
        Type type = binary.left().type();
        String value;
        if (type instanceof Type.RealType) {
            value = SmtLib.onReals(operator, left.value, right.value);
        } else if (type instanceof Type.BooleanType) {
            boolean equal = operator != BinaryOperator.NOT_EQUAL;
            String same = same(left.value, right.value);
            value = equal ? same : not(same);
        } else {
            value = SmtLib.onIntegers(operator, left.value, right.value);
            if (operator == BinaryOperator.DIVIDE || operator == BinaryOperator.REMAINDER) {
                wrong.add(same(right.value, SmtLib.vector(0, SmtLib.bits(type))));
            }
            if (binary.type() instanceof Type.IntegerType) {
                wraps.add(
                        SmtLib.differs(
                                operator, left.value, right.value, value, SmtLib.bits(type)));
            }
        }
        return new Coded(value, disjunction(wrong), disjunction(wraps));
    }

    @Override
    public Coded conditional(Expression.Conditional choice) {
        Coded condition = of(choice.condition());
        Coded then = of(choice.then());
        Coded otherwise = of(choice.otherwise());
        Function<Function<Coded, String>, String> chosen =
                part ->
                        "(ite %s %s %s)"
                                .formatted(
                                        condition.value, part.apply(then), part.apply(otherwise));
        return new Coded(
                chosen.apply(Coded::value),
                disjunction(List.of(condition.wrong, chosen.apply(Coded::wrong))),
                disjunction(List.of(condition.wraps, chosen.apply(Coded::wraps))));
    }

    @Override
    public Coded judged(Expression.Judged judged) {
        throw new AssertionError(judged);
    }

    @Override
    public Coded cast(Expression.Cast cast) {
        Coded operand = of(cast.operand());
        Type from = cast.operand().type();
        Type to = cast.type();
        if (to instanceof Type.RealType) {
            boolean unsigned = from instanceof Type.CharacterType;
            String number =
                    unsigned ? SmtLib.extended(operand.value, from, Integer.SIZE) : operand.value;
            return new Coded(
                    "(" + SmtLib.convert(to) + " RNE " + number + ")",
                    operand.wrong,
                    operand.wraps);
        }
        int narrow = SmtLib.bits(to);
        int wide = SmtLib.bits(from);
        String value =
                narrow > wide
                        ? SmtLib.extended(operand.value, from, narrow)
                        : "((_ extract %d 0) %s)".formatted(narrow - 1, operand.value);
        int enough = 2 * Long.SIZE;
        String same =
                same(
                        SmtLib.extended(value, to, enough),
                        SmtLib.extended(operand.value, from, enough));
        return new Coded(value, operand.wrong, disjunction(List.of(operand.wraps, not(same))));
    }
}
