package arcomat.semantics.value;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;

/**
 * Samples between numbers of single or double precision, where between two of them there need not
 * be another one. What is infinite is the last resort.
 */
final class RealGaps {
    private final Type.RealType type;
    private final double[] numbers;
    private final List<Value> samples = new ArrayList<>();

    /**
     * @param values of the type, in their natural order, without NaN; at least one
     */
    RealGaps(Type.RealType type, List<Value> values) {
        this.type = type;
        numbers = values.stream().mapToDouble(value -> ((Value.RealValue) value).value()).toArray();
    }

    /** One number of each gap: before the first, between two, behind the last. */
    List<Value> samples() {
        int last = numbers.length - 1;
        if (numbers[0] > Double.NEGATIVE_INFINITY) {
            double wanted = type.rounded(numbers[0] - 1);
            add(Double.isFinite(wanted) && wanted < numbers[0] ? wanted : type.below(numbers[0]));
        }
        for (int i = 0; i < last; i++) {
            addBetween(numbers[i], numbers[i + 1]);
        }
        if (numbers[last] < Double.POSITIVE_INFINITY) {
            double wanted = type.rounded(numbers[last] + 1);
            add(
                    Double.isFinite(wanted) && wanted > numbers[last]
                            ? wanted
                            : type.above(numbers[last]));
        }
        return samples;
    }

    /** The middle or else, if that is not between them, the next number that is. */
    private void addBetween(double low, double high) {
        double middle = type.rounded(low / 2 + high / 2);
        if (low < middle && middle < high) {
            add(middle);
        } else if (type.above(low) < high) {
            add(type.above(low));
        }
    }

    private void add(double number) {
        // There is only one zero: -0.0 equals 0.0.
        samples.add(new Value.RealValue(number + 0.0));
    }
}
