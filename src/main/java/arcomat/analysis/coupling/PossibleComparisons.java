package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Comparisons that may be so of variables, the strongest first; those that an example does not show
 * are left out from the beginning.
 *
 * @param variables that are compared
 * @param numbers that models mention
 */
record PossibleComparisons(List<Port> variables, Set<Long> numbers) {
    /** The numbers in some expressions. */
    static Set<Long> numbers(List<Expression> expressions) {
        Set<Long> numbers = new LinkedHashSet<>(List.of(0L));
        for (Expression each : expressions) {
            each.visit(
                    part -> {
                        if (part instanceof Expression.Constant constant
                                && constant.value() instanceof Value.IntegerValue number) {
                            numbers.add(number.value());
                        }
                    });
        }
        return numbers;
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
            all.add(
                    new Comparison(
                            variables.get(one),
                            BinaryOperator.EQUAL,
                            ComparedValue.of(row.get(one))));
        }
        for (int one = 0; one < row.size(); one++) {
            for (int other = one + 1; other < row.size(); other++) {
                addOrdered(one, other, all);
            }
        }
        for (int one = 0; one < row.size(); one++) {
            addBounds(one, all);
        }
        return all;
    }

    private boolean isWhole(int variable) {
        return variables.get(variable).type() instanceof Type.IntegerType;
    }

    private void addEqual(int one, int other, List<Value> row, List<Comparison> all) {
        Port variable = variables.get(one);
        Port second = variables.get(other);
        if (!isWhole(one) || !isWhole(other)) {
            if (variable.type().equals(second.type())) {
                all.add(equal(variable, ComparedValue.of(second, false, 0)));
            }
            return;
        }
        long more = row.get(one).whole() - row.get(other).whole();
        all.add(equal(variable, ComparedValue.of(second, false, more)));
        long sum = row.get(one).whole() + row.get(other).whole();
        all.add(equal(variable, ComparedValue.of(second, true, sum)));
    }

    private static Comparison equal(Port variable, ComparedValue measure) {
        return new Comparison(variable, BinaryOperator.EQUAL, measure);
    }

    private void addOrdered(int one, int other, List<Comparison> all) {
        if (isWhole(one) && isWhole(other)) {
            addOrdered(variables.get(one), ComparedValue.of(variables.get(other), false, 0), all);
        }
    }

    private void addBounds(int one, List<Comparison> all) {
        if (isWhole(one)) {
            numbers.forEach(
                    number ->
                            addOrdered(
                                    variables.get(one),
                                    ComparedValue.of(new Value.IntegerValue(number)),
                                    all));
        }
    }

    private static void addOrdered(Port variable, ComparedValue measure, List<Comparison> all) {
        for (BinaryOperator operator :
                List.of(BinaryOperator.LESS_OR_EQUAL, BinaryOperator.GREATER_OR_EQUAL)) {
            all.add(new Comparison(variable, operator, measure));
        }
    }
}
