package arcomat.semantics.expression;

import arcomat.model.Type;
import arcomat.model.Value;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.DoubleStream;

/**
 * Which places hold the same data, and what is done with them. A place is a port, a variable or a
 * signal; data that are copied from one to another, or compared with each other, are of one sort.
 *
 * <p>A sort is <em>free</em> where its data are only copied, compared for equality with each other,
 * and compared with constants. Whatever a model does, it then does as well with other values in
 * their stead, if different values stay different, constants stay themselves, and no value moves
 * past a constant that it is ordered with (data independence: Wolper 1986, Lazić 1999).
 */
public final class DataSorts {
    private final List<Facts> places = new ArrayList<>();

    /** What is known of a place; that of its sort is with the last one of the chain. */
    private static final class Facts {
        private @Nullable Facts joined;
        private final int number;
        private final Set<Type> types = new LinkedHashSet<>();
        private final Set<Value> constants = new TreeSet<>();
        private boolean ordered;
        private boolean calculated;

        Facts(int number) {
            this.number = number;
        }
    }

    /**
     * A sort of data.
     *
     * @param number different for each sort
     * @param type of all its values; empty ranges aside, that of the widest place
     * @param free whether other values may stand in
     * @param constants in their natural order
     * @param ordered whether it matters between which of the constants a value lies
     */
    public record Sort(
            int number, Type type, boolean free, List<Value> constants, boolean ordered) {
        public Sort {
            constants = List.copyOf(constants);
        }
    }

    /** A new place, of a sort of its own. */
    public int place(Type type) {
        places.add(new Facts(places.size()));
        carries(places.size() - 1, type);
        return places.size() - 1;
    }

    /** A place is also seen as one of another type. */
    public void carries(int place, Type type) {
        facts(place).types.add(type);
    }

    /** Data get from one place to the other, or are compared. */
    public void join(int one, int other) {
        Facts kept = facts(one);
        Facts gone = facts(other);
        if (kept != gone) {
            gone.joined = kept;
            kept.types.addAll(gone.types);
            kept.constants.addAll(gone.constants);
            kept.ordered |= gone.ordered;
            kept.calculated |= gone.calculated;
        }
    }

    /** A constant gets to a place, or is compared with what is there. */
    public void mention(int place, Value constant) {
        facts(place).constants.add(constant);
    }

    /** What is at a place is less than a constant, or not. */
    void order(int place, Value constant) {
        mention(place, constant);
        facts(place).ordered = true;
    }

    /** Something else is done with what is at a place, or brings it there. */
    void calculate(int place) {
        facts(place).calculated = true;
    }

    private Facts facts(int place) {
        Facts facts = places.get(place);
        while (facts.joined != null) {
            facts = facts.joined;
        }
        return facts;
    }

    Set<Type> types(int place) {
        return facts(place).types;
    }

    /** The sort of a place, after all that there is to say has been said. */
    public Sort sort(int place) {
        Facts facts = facts(place);
        Type first = facts.types.iterator().next();
        if (facts.types.stream().allMatch(Type.IntegerType.class::isInstance)) {
            return numbers(facts);
        }
        boolean free = !facts.calculated && facts.types.size() == 1;
        if (first instanceof Type.RealType) {
            // What is not equal to itself, what is equal to another value, and both ends.
            DoubleStream.of(
                            Double.NEGATIVE_INFINITY,
                            -0.0,
                            0.0,
                            Double.POSITIVE_INFINITY,
                            Double.NaN)
                    .mapToObj(Value.RealValue::new)
                    .forEach(facts.constants::add);
        }
        return new Sort(facts.number, first, free, List.copyOf(facts.constants), facts.ordered);
    }

    /** Where a number fits into one place and not into another, the ends of its range matter. */
    private static Sort numbers(Facts facts) {
        List<Type.IntegerType> types =
                facts.types.stream().map(Type.IntegerType.class::cast).toList();
        Type.IntegerType widest = types.stream().reduce(DataSorts::widest).orElseThrow();
        Set<Value> constants = new TreeSet<>();
        constants.addAll(facts.constants);
        boolean ordered = facts.ordered;
        for (Type.IntegerType each : types) {
            ordered |= each.low() > widest.low() || each.high() < widest.high();
            if (each.low() > widest.low()) {
                constants.add(new Value.IntegerValue(each.low()));
            }
            if (each.high() < widest.high()) {
                constants.add(new Value.IntegerValue(each.high()));
            }
        }
        return new Sort(facts.number, widest, !facts.calculated, List.copyOf(constants), ordered);
    }

    /** A type that has room for the values of both. */
    private static Type.IntegerType widest(Type.IntegerType one, Type.IntegerType other) {
        return new Type.IntegerType(
                Collections.max(List.of(one.width(), other.width())),
                Math.min(one.low(), other.low()),
                Math.max(one.high(), other.high()),
                one.ranged() || other.ranged());
    }
}
