package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Comparisons that may be so of variables, the strongest first; those that an example does not show
 * are left out from the beginning.
 *
 * @param variables that are compared
 * @param mentioned values that models mention
 */
record PossibleComparisons(List<Port> variables, Set<Value> mentioned) {
    /** The values in some expressions, and zero. */
    static Set<Value> mentioned(List<Expression> expressions) {
        Set<Value> values = new LinkedHashSet<>(List.of(new Value.IntegerValue(0)));
        for (Expression each : expressions) {
            each.visit(
                    part -> {
                        if (part instanceof Expression.Constant constant) {
                            values.add(constant.value());
                        }
                    });
        }
        return values;
    }

    /**
     * All that an example shows.
     *
     * @param row values of the variables, by position
     */
    List<Comparison> shownBy(List<Value> row) {
        List<Comparison> all = new ArrayList<>();
        for (int one = 0; one < row.size(); one++) {
            for (int other = one + 1; other < row.size(); other++) {
                addEqual(one, other, row, all);
            }
        }
        for (int one = 0; one < row.size(); one++) {
            addOwn(variables.get(one), row.get(one), all);
        }
        for (int one = 0; one < row.size(); one++) {
            for (int other = one + 1; other < row.size(); other++) {
                addOrdered(variables.get(one), variables.get(other), all);
            }
        }
        variables.forEach(each -> addBounds(each, all));
        return all;
    }

    private static boolean isWhole(Port variable) {
        return variable.type() instanceof Type.IntegerType;
    }

    private static boolean isReal(Port variable) {
        return variable.type() instanceof Type.RealType;
    }

    private void addEqual(int one, int other, List<Value> row, List<Comparison> all) {
        Port variable = variables.get(one);
        Port second = variables.get(other);
        if (isWhole(variable) && isWhole(second)) {
            long more = row.get(one).whole() - row.get(other).whole();
            all.add(same(variable, ComparedValue.of(second, false, more)));
            long sum = row.get(one).whole() + row.get(other).whole();
            all.add(same(variable, ComparedValue.of(second, true, sum)));
        } else if (variable.type().equals(second.type())) {
            all.add(same(variable, read(second)));
            if (isReal(variable)) {
                all.add(same(variable, ComparedValue.of(second, true, 0)));
                all.add(new Comparison(variable, Relation.EQUAL, read(second)));
            }
        }
    }

    private static ComparedValue read(Port variable) {
        return ComparedValue.of(variable, false, 0);
    }

    private static Comparison same(Port variable, ComparedValue measure) {
        return new Comparison(variable, Relation.same(variable.type()), measure);
    }

    /** What is so of a variable alone; a number is one that is equal to itself. */
    private static void addOwn(Port variable, Value value, List<Comparison> all) {
        all.add(same(variable, ComparedValue.of(value)));
        if (isReal(variable)) {
            all.add(new Comparison(variable, Relation.EQUAL, read(variable)));
        }
    }

    private static void addOrdered(Port one, Port other, List<Comparison> all) {
        if (isWhole(one) && isWhole(other) || isReal(one) && one.type().equals(other.type())) {
            addOrdered(one, read(other), all);
        }
    }

    private static void addOrdered(Port variable, ComparedValue measure, List<Comparison> all) {
        Relation.orders(variable.type())
                .forEach(each -> all.add(new Comparison(variable, each, measure)));
    }

    private void addBounds(Port variable, List<Comparison> all) {
        if (variable.type() instanceof Type.StringType) {
            fitting(variable.type())
                    .map(ComparedValue::of)
                    .forEach(text -> all.add(new Comparison(variable, Relation.NOT_EQUAL, text)));
        } else if (isWhole(variable) || isReal(variable)) {
            fitting(variable.type())
                    .map(ComparedValue::of)
                    .forEach(number -> addOrdered(variable, number, all));
        }
    }

    /** What is mentioned, as far as a variable of some type can be compared with it. */
    private Stream<Value> fitting(Type type) {
        return mentioned.stream()
                .map(each -> type instanceof Type.RealType ? real(each) : each)
                .filter(each -> isComparable(each, type))
                .distinct();
    }

    private static Value real(Value value) {
        return value instanceof Value.IntegerValue number
                ? new Value.RealValue((double) number.value())
                : value;
    }

    /** Whole numbers are compared with any, also beyond their range. */
    private static boolean isComparable(Value value, Type type) {
        return type instanceof Type.IntegerType
                ? value instanceof Value.IntegerValue
                : type.has(value);
    }
}
