package arcomat.pipeline.campaign.measure;

import arcomat.campaign.Measure;
import arcomat.model.Value;
import arcomat.world.Physics;
import arcomat.world.Scene;

import org.jspecify.annotations.Nullable;

/** What an expression has been in a run so far. Moments at which it is undefined say nothing. */
abstract class Fold {
    private static final double MILLISECONDS = 1000;

    static Fold of(Measure.Fold way) {
        return switch (way) {
            case LARGEST -> new Extreme(1);
            case SMALLEST -> new Extreme(-1);
            case MEAN -> new Mean();
            case LAST -> new Last();
            case SECONDS -> new Held();
            case WHEN -> new Ever();
        };
    }

    /** The value at a moment; null where there is none. */
    abstract void see(Scene scene, @Nullable Value value);

    /** In the end; not a number, where the expression was undefined all the time. */
    abstract double answer();

    private static boolean isTrue(@Nullable Value value) {
        return value instanceof Value.BooleanValue truth && truth.value();
    }

    private abstract static class OfNumber extends Fold {
        /** Reals divided by zero are infinite, and no more known than integers are. */
        @Override
        final void see(Scene scene, @Nullable Value value) {
            if (value instanceof Value.RealValue real && Double.isFinite(real.value())) {
                add(real.value());
            }
        }

        abstract void add(double number);
    }

    private static final class Extreme extends OfNumber {
        private final int sign;
        private double extreme = Double.NaN;

        Extreme(int sign) {
            this.sign = sign;
        }

        @Override
        void add(double number) {
            if (Double.isNaN(extreme) || sign * number > sign * extreme) {
                extreme = number;
            }
        }

        @Override
        double answer() {
            return extreme;
        }
    }

    private static final class Mean extends OfNumber {
        private double sum;
        private long count;

        @Override
        void add(double number) {
            sum += number;
            count++;
        }

        @Override
        double answer() {
            return count == 0 ? Double.NaN : sum / count;
        }
    }

    private static final class Last extends OfNumber {
        private double last = Double.NaN;

        @Override
        void add(double number) {
            last = number;
        }

        @Override
        double answer() {
            return last;
        }
    }

    private static final class Held extends Fold {
        private long steps;
        private boolean known;

        /** What is true at the beginning has not held for any time yet. */
        @Override
        void see(Scene scene, @Nullable Value value) {
            known |= value != null;
            steps += scene.tick() > 0 && isTrue(value) ? 1 : 0;
        }

        @Override
        double answer() {
            return known ? steps * Physics.STEP / MILLISECONDS : Double.NaN;
        }
    }

    private static final class Ever extends Fold {
        private boolean happened;
        private boolean known;

        @Override
        void see(Scene scene, @Nullable Value value) {
            known |= value != null;
            happened |= isTrue(value);
        }

        @Override
        double answer() {
            double truth = happened ? 1 : 0;
            return known ? truth : Double.NaN;
        }
    }
}
