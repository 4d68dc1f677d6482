package arcomat.analysis.smt;

import arcomat.model.Type;
import arcomat.model.Value;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;

/**
 * Values as numbers and truth values. Constants of enumerations and characters have their position,
 * texts a number of their own. Reals and objects are numbers of which nothing is known.
 */
final class Encoding implements Value.Cases<Term> {
    private final Solver solver;
    private final List<String> texts = new ArrayList<>();

    Encoding(Solver solver) {
        this.solver = solver;
    }

    /** Whether equal values have equal codes, and only they. */
    static boolean isExact(Type type) {
        return !(type instanceof Type.RealType || type instanceof Type.ClassType);
    }

    static boolean isTruth(Type type) {
        return type instanceof Type.BooleanType;
    }

    /** The code of a value of an exact type. */
    Term encode(Value value) {
        return value.match(this);
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
        if (type instanceof Type.IntegerType integer) {
            return solver.between(integer.low(), code, integer.high());
        }
        if (type instanceof Type.EnumType enumeration) {
            return solver.between(0, code, enumeration.constants().size() - 1);
        }
        return type instanceof Type.CharacterType
                ? solver.between(0, code, Character.MAX_VALUE)
                : solver.of(true);
    }

    /** The value that an example gives a code. */
    Value decode(Term code, Type type) {
        if (isTruth(type)) {
            return new Value.BooleanValue(solver.truthOf(code));
        }
        BigInteger number = solver.numberOf(code);
        if (type instanceof Type.IntegerType) {
            return new Value.IntegerValue(number.longValue());
        }
        if (type instanceof Type.EnumType enumeration) {
            return new Value.EnumValue(enumeration, number.intValue());
        }
        if (type instanceof Type.CharacterType) {
            return new Value.CharacterValue((char) number.intValue());
        }
        return type instanceof Type.StringType ? text(number) : type.first();
    }

    private Value text(BigInteger number) {
        boolean known = number.signum() >= 0 && number.compareTo(size()) < 0;
        return new Value.StringValue(known ? texts.get(number.intValue()) : "text " + number);
    }

    private BigInteger size() {
        return BigInteger.valueOf(texts.size());
    }
}
