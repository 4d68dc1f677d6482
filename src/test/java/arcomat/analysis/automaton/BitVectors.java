package arcomat.analysis.automaton;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * An automaton whose inputs are all total, step by step, in the language of SMT-LIB: integers are
 * vectors of bits, doubles are IEEE 754. Shares no code with the analyses.
 */
final class BitVectors {

    /**
     * An expression at one step.
     *
     * @param wrong when its evaluation divides by zero
     * @param wraps when it meets an integer that wraps around
     */
    private record Coded(String value, String wrong, String wraps) {}

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
            declare(name("p", port.name(), step), port.type(), lines);
        }
        for (Variable variable : automaton.variables()) {
            declare(name("v", variable.name(), step), variable.type(), lines);
        }
        return lines;
    }

    private static void declare(String name, Type type, List<String> lines) {
        lines.add("(declare-const " + name + " " + sort(type) + ")");
        if (type instanceof Type.IntegerType integer && integer.ranged()) {
            lines.add("(assert " + isWithin(name, integer) + ")");
        }
    }

    private static String isWithin(String value, Type.IntegerType type) {
        int bits = bits(type);
        return "(and (bvsle %s %s) (bvsle %s %s))"
                .formatted(vector(type.low(), bits), value, value, vector(type.high(), bits));
    }

    private static String name(String kind, String name, int step) {
        return kind + "." + name + "@" + step;
    }

    /** Step 0 is a beginning: one initial state, whose variables have their first values. */
    String beginning() {
        List<String> all = new ArrayList<>();
        all.add("(= state@0 " + automaton.initials().get(0).state() + ")");
        for (Variable variable : automaton.variables()) {
            all.add(same(name("v", variable.name(), 0), coded(variable.initial(), 0).value));
        }
        return conjunction(all);
    }

    /** A transition can be taken at a step. */
    String enabled(int index, int step) {
        Coded guard = guard(index, step);
        return conjunction(List.of(isAtSource(index, step), guard.value, not(guard.wrong)));
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
        effects(index).forEach(each -> effects.add(coded(each, step).wraps));
        return disjunction(
                List.of(
                        conjunction(List.of(isAtSource(index, step), guard.wraps)),
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
            all.add(not(coded(effect, step).wrong));
        }
        for (Automaton.Send send : transition(index).sends()) {
            for (Expression value : ((Automaton.Messages) send.emission()).values()) {
                all.add(fits(value, send.port().type(), step));
            }
        }
        for (Variable variable : automaton.variables()) {
            String after = name("v", variable.name(), step);
            for (Automaton.Assignment assignment : transition(index).assignments()) {
                if (assignment.variable().name().equals(variable.name())) {
                    after = coded(assignment.value(), step).value;
                    all.add(fits(assignment.value(), variable.type(), step));
                }
            }
            all.add(same(name("v", variable.name(), step + 1), after));
        }
        return conjunction(all);
    }

    private String fits(Expression value, Type type, int step) {
        return type instanceof Type.IntegerType integer && integer.ranged()
                ? isWithin(coded(value, step).value, integer)
                : "true";
    }

    private Coded guard(int index, int step) {
        return transition(index)
                .guard()
                .map(guard -> coded(guard, step))
                .orElse(new Coded("true", "false", "false"));
    }

    private Coded coded(Expression e, int step) {
        if (e instanceof Expression.Constant constant) {
            return plain(literal(constant.value(), constant.type()));
        }
        if (e instanceof Expression.ParameterRead read) {
            return plain(literal(arguments.get(position(read)), read.type()));
        }
        if (e instanceof Expression.PortRead read) {
            return plain(name("p", read.port().name(), step));
        }
        if (e instanceof Expression.VariableRead read) {
            return plain(name("v", read.variable().name(), step));
        }
        if (e instanceof Expression.Unary unary) {
            return unary(unary, coded(unary.operand(), step));
        }
        if (e instanceof Expression.Cast cast) {
            return cast(cast, coded(cast.operand(), step));
        }
        if (e instanceof Expression.Conditional choice) {
            Coded condition = coded(choice.condition(), step);
            Coded then = coded(choice.then(), step);
            Coded otherwise = coded(choice.otherwise(), step);
            Function<Function<Coded, String>, String> chosen =
                    part ->
                            "(ite %s %s %s)"
                                    .formatted(
                                            condition.value,
                                            part.apply(then),
                                            part.apply(otherwise));
            return new Coded(
                    chosen.apply(Coded::value),
                    disjunction(List.of(condition.wrong, chosen.apply(Coded::wrong))),
                    disjunction(List.of(condition.wraps, chosen.apply(Coded::wraps))));
        }
        Expression.Binary binary = (Expression.Binary) e;
        return binary(binary, coded(binary.left(), step), coded(binary.right(), step));
    }

    private int position(Expression.ParameterRead read) {
        for (int i = 0; i < component.parameters().size(); i++) {
            if (component.parameters().get(i).name().equals(read.parameter().name())) {
                return i;
            }
        }
        throw new AssertionError(read);
    }

    private static Coded plain(String value) {
        return new Coded(value, "false", "false");
    }

    private static Coded unary(Expression.Unary unary, Coded operand) {
        return switch (unary.operator()) {
            case NOT -> new Coded(not(operand.value), operand.wrong, operand.wraps);
            case COMPLEMENT ->
                    new Coded("(bvnot " + operand.value + ")", operand.wrong, operand.wraps);
            case NEGATE -> {
                if (unary.type() instanceof Type.RealType) {
                    yield new Coded("(fp.neg " + operand.value + ")", operand.wrong, operand.wraps);
                }
                int bits = bits(unary.type());
                String least = vector(BigInteger.ONE.shiftLeft(bits - 1), bits);
                yield new Coded(
                        "(bvneg " + operand.value + ")",
                        operand.wrong,
                        disjunction(List.of(operand.wraps, same(operand.value, least))));
            }
        };
    }

    private static Coded binary(Expression.Binary binary, Coded left, Coded right) {
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
            value = onReals(operator, left.value, right.value);
        } else if (type instanceof Type.BooleanType) {
            boolean equal = operator != BinaryOperator.NOT_EQUAL;
            String same = same(left.value, right.value);
            value = equal ? same : not(same);
        } else {
            value = onIntegers(operator, left.value, right.value);
            if (operator == BinaryOperator.DIVIDE || operator == BinaryOperator.REMAINDER) {
                wrong.add(same(right.value, vector(0, bits(type))));
            }
            if (binary.type() instanceof Type.IntegerType) {
                wraps.add(differs(operator, left.value, right.value, value, bits(type)));
            }
        }
        return new Coded(value, disjunction(wrong), disjunction(wraps));
    }

    /** Computed with twice as many bits, it is another number. */
    private static String differs(
            BinaryOperator operator, String left, String right, String result, int bits) {
        if (operator == BinaryOperator.REMAINDER) {
            return "false";
        }
        Function<String, String> wide = value -> "((_ sign_extend " + bits + ") " + value + ")";
        String exact = onIntegers(operator, wide.apply(left), wide.apply(right));
        String differs = not(same(exact, wide.apply(result)));
        return operator == BinaryOperator.DIVIDE
                ? conjunction(List.of(not(same(right, vector(0, bits))), differs))
                : differs;
    }

    private static String onIntegers(BinaryOperator operator, String left, String right) {
        return switch (operator) {
            case PLUS -> apply("bvadd", left, right);
            case MINUS -> apply("bvsub", left, right);
            case MULTIPLY -> apply("bvmul", left, right);
            case DIVIDE -> apply("bvsdiv", left, right);
            case REMAINDER -> apply("bvsrem", left, right);
            case LESS -> apply("bvslt", left, right);
            case LESS_OR_EQUAL -> apply("bvsle", left, right);
            case GREATER -> apply("bvsgt", left, right);
            case GREATER_OR_EQUAL -> apply("bvsge", left, right);
            case EQUAL -> same(left, right);
            case NOT_EQUAL -> not(same(left, right));
            default -> throw new AssertionError(operator);
        };
    }

    private static String onReals(BinaryOperator operator, String left, String right) {
        return switch (operator) {
            case PLUS -> apply("fp.add RNE", left, right);
            case MINUS -> apply("fp.sub RNE", left, right);
            case MULTIPLY -> apply("fp.mul RNE", left, right);
            case DIVIDE -> apply("fp.div RNE", left, right);
            case LESS -> apply("fp.lt", left, right);
            case LESS_OR_EQUAL -> apply("fp.leq", left, right);
            case GREATER -> apply("fp.gt", left, right);
            case GREATER_OR_EQUAL -> apply("fp.geq", left, right);
            case EQUAL -> apply("fp.eq", left, right);
            case NOT_EQUAL -> not(apply("fp.eq", left, right));
            default -> throw new AssertionError(operator);
        };
    }

    private static Coded cast(Expression.Cast cast, Coded operand) {
        Type from = cast.operand().type();
        Type to = cast.type();
        if (to instanceof Type.RealType) {
            return new Coded(
                    "(" + convert(to) + " RNE " + operand.value + ")",
                    operand.wrong,
                    operand.wraps);
        }
        int narrow = bits(to);
        int wide = bits(from);
        String value =
                narrow > wide
                        ? extended(operand.value, from, narrow)
                        : "((_ extract %d 0) %s)".formatted(narrow - 1, operand.value);
        int enough = 2 * Long.SIZE;
        String same = same(extended(value, to, enough), extended(operand.value, from, enough));
        return new Coded(value, operand.wrong, disjunction(List.of(operand.wraps, not(same))));
    }

    private static String extended(String value, Type type, int bits) {
        String extend = type instanceof Type.CharacterType ? "zero_extend" : "sign_extend";
        return "((_ %s %d) %s)".formatted(extend, bits - bits(type), value);
    }

    private static String convert(Type type) {
        return ((Type.RealType) type).single() ? "(_ to_fp 8 24)" : "(_ to_fp 11 53)";
    }

    private static String sort(Type type) {
        if (type instanceof Type.BooleanType) {
            return "Bool";
        }
        if (type instanceof Type.RealType real) {
            return real.single() ? "(_ FloatingPoint 8 24)" : "(_ FloatingPoint 11 53)";
        }
        return "(_ BitVec " + bits(type) + ")";
    }

    private static int bits(Type type) {
        if (type instanceof Type.CharacterType) {
            return Character.SIZE;
        }
        return switch (((Type.IntegerType) type).width()) {
            case BYTE -> Byte.SIZE;
            case SHORT -> Short.SIZE;
            case INT -> Integer.SIZE;
            case LONG -> Long.SIZE;
        };
    }

    private static String literal(Value value, Type type) {
        if (value instanceof Value.BooleanValue truth) {
            return String.valueOf(truth.value());
        }
        if (value instanceof Value.RealValue real) {
            boolean single = ((Type.RealType) type).single();
            String bits =
                    single
                            ? "#x%08x".formatted(Float.floatToIntBits((float) real.value()))
                            : "#x%016x".formatted(Double.doubleToLongBits(real.value()));
            return "(" + convert(type) + " " + bits + ")";
        }
        long number =
                value instanceof Value.CharacterValue character
                        ? character.value()
                        : ((Value.IntegerValue) value).value();
        return vector(number, bits(type));
    }

    private static String vector(long number, int bits) {
        return vector(BigInteger.valueOf(number), bits);
    }

    private static String vector(BigInteger number, int bits) {
        return "(_ bv" + number.mod(BigInteger.ONE.shiftLeft(bits)) + " " + bits + ")";
    }

    private static String apply(String function, String left, String right) {
        return "(" + function + " " + left + " " + right + ")";
    }

    private static String same(String one, String two) {
        return apply("=", one, two);
    }

    private static String not(String condition) {
        return "(not " + condition + ")";
    }

    private static String conjunction(List<String> all) {
        return "(and true " + String.join(" ", all) + ")";
    }

    private static String disjunction(List<String> any) {
        return "(or false " + String.join(" ", any) + ")";
    }
}
