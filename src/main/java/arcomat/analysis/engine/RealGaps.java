package arcomat.analysis.engine;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;

/**
 * Samples between numbers of single or double precision, where between two of them there need not
 * be another one. Only numbers that a model can write down: not what is infinite.
 */
final class RealGaps {
    private final boolean single;
    private final double[] numbers;
    private final List<Value> samples = new ArrayList<>();

    /**
     * @param values of the type, finite, in their natural order; at least one
     */
    RealGaps(Type.RealType type, List<Value> values) {
        single = type.single();
        numbers = values.stream().mapToDouble(value -> ((Value.RealValue) value).value()).toArray();
    }

    /** One number of each gap: before the first, between two, behind the last. */
    List<Value> samples() {
        int last = numbers.length - 1;
        add(Double.NEGATIVE_INFINITY, numbers[0] - 1, numbers[0]);
        for (int i = 0; i < last; i++) {
            add(numbers[i], numbers[i] / 2 + numbers[i + 1] / 2, numbers[i + 1]);
        }
        add(numbers[last], numbers[last] + 1, Double.POSITIVE_INFINITY);
        return samples;
    }

    /** The wanted number or else, if that is not inside of the gap, the next one that is. */
    private void add(double low, double wanted, double high) {
        double rounded = single ? (float) wanted : wanted;
        if (low < rounded && rounded < high) {
            add(rounded);
            return;
        }
        double next = Double.isInfinite(low) ? below(high) : above(low);
        if (low < next && next < high) {
            add(next);
        }
    }

    private double above(double number) {
        return single ? Math.nextUp((float) number) : Math.nextUp(number);
    }

    private double below(double number) {
        return single ? Math.nextDown((float) number) : Math.nextDown(number);
    }

    private void add(double number) {
        // There is only one zero: -0.0 equals 0.0.
        samples.add(new Value.RealValue(number + 0.0));
    }
}
