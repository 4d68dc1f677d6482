package arcomat.analysis.smt;

import arcomat.model.Type;
import arcomat.model.Value;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * Values as numbers and truth values. Constants of enumerations and characters have their position,
 * texts a number of their own; reals are numbered in their order ({@link RealCodes}). Objects are
 * numbers of which nothing is known.
 */
final class Encoding implements Value.Cases<Term>, Type.Cases<Encoding.Codes> {
    /**
     * The codes of a type.
     *
     * @param range what a code is restricted to
     * @param meaning the value that an example gives a code
     */
    record Codes(UnaryOperator<Term> range, Function<Term, Value> meaning) {}

    private final Solver solver;
    private final boolean reals;
    private final List<String> texts = new ArrayList<>();

    /**
     * @param reals whether numbers of floating point are exact, too, and operations that are not
     *     known give the same for the same; else nothing is known of either
     */
    Encoding(Solver solver, boolean reals) {
        this.solver = solver;
        this.reals = reals;
    }

    /** Whether numbers of floating point are exact, too. */
    boolean areExact() {
        return reals;
    }

    /** Whether equal values have equal codes, and only they. */
    boolean isExact(Type type) {
        return !(type instanceof Type.ClassType) && (reals || !(type instanceof Type.RealType));
    }

    static boolean isTruth(Type type) {
        return type instanceof Type.BooleanType;
    }

    /** The code of a value of an exact type. */
    Term encode(Value value, Type type) {
        return type instanceof Type.RealType real
                ? solver.number(RealCodes.of(real).code(number(value)))
                : value.match(this);
    }

    private static double number(Value value) {
        return value instanceof Value.RealValue real ? real.value() : value.whole();
    }

    @Override
    public Term booleanValue(Value.BooleanValue truth) {
        return solver.of(truth.value());
    }

    @Override
    public Term integerValue(Value.IntegerValue integer) {
        return solver.number(integer.value());
    }

    @Override
    public Term enumValue(Value.EnumValue constant) {
        return solver.number(constant.ordinal());
    }

    @Override
    public Term characterValue(Value.CharacterValue character) {
        return solver.number(character.value());
    }

    @Override
    public Term stringValue(Value.StringValue text) {
        if (!texts.contains(text.value())) {
            texts.add(text.value());
        }
        return solver.number(texts.indexOf(text.value()));
    }

    @Override
    public Term realValue(Value.RealValue real) {
        throw new AssertionError(real);
    }

    @Override
    public Term objectValue(Value.ObjectValue object) {
        throw new AssertionError(object);
    }

    /** What the codes of a type are restricted to; true where they are not. */
    Term range(Term code, Type type) {
        return type.match(this).range().apply(code);
    }

    /** The value that an example gives a code. */
    Value decode(Term code, Type type) {
        return type.match(this).meaning().apply(code);
    }

    @Override
    public Codes booleanType(Type.BooleanType type) {
        return any(code -> new Value.BooleanValue(solver.truthOf(code)));
    }

    @Override
    public Codes integerType(Type.IntegerType type) {
        return numbers(
                type.low(), type.high(), number -> new Value.IntegerValue(number.longValue()));
    }

    @Override
    public Codes enumType(Type.EnumType type) {
        return numbers(
                0,
                type.constants().size() - 1,
                number -> new Value.EnumValue(type, number.intValue()));
    }

    @Override
    public Codes characterType(Type.CharacterType type) {
        return numbers(
                0,
                Character.MAX_VALUE,
                number -> new Value.CharacterValue((char) number.intValue()));
    }

    @Override
    public Codes stringType(Type.StringType type) {
        return any(code -> text(solver.numberOf(code)));
    }

    @Override
    public Codes realType(Type.RealType type) {
        if (!reals) {
            return any(unknown -> type.first());
        }
        RealCodes codes = RealCodes.of(type);
        return new Codes(
                code -> solver.between(codes.least(), code, codes.most()),
                code -> new Value.RealValue(codes.real(solver.numberOf(code).longValueExact())));
    }

    @Override
    public Codes classType(Type.ClassType type) {
        return any(unknown -> type.first());
    }

    private Codes any(Function<Term, Value> meaning) {
        return new Codes(code -> solver.of(true), meaning);
    }

    private Codes numbers(long low, long high, Function<BigInteger, Value> meaning) {
        return new Codes(
                code -> solver.between(low, code, high),
                code -> meaning.apply(solver.numberOf(code)));
    }

    private Value text(BigInteger number) {
        boolean known = number.signum() >= 0 && number.compareTo(size()) < 0;
        return new Value.StringValue(known ? texts.get(number.intValue()) : "text " + number);
    }

    private BigInteger size() {
        return BigInteger.valueOf(texts.size());
    }
}
