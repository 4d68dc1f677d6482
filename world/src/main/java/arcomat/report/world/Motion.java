package arcomat.report.world;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** A way, by as few of its frames as show it. */
final class Motion {
    /** What is nearer to the way, in mm and degrees, cannot be told from it. */
    private static final double NEAR = 1.5;

    private Motion() {}

    /**
     * Where something is drawn.
     *
     * @param x in mm
     * @param y in mm, downwards
     * @param turned in degrees, to the right; grows beyond a whole turn
     */
    record Place(double x, double y, double turned) {}

    /**
     * The frames that stay: straight and even motion from each one to the next comes near to all
     * between them. The first and the last one are among them.
     */
    static List<Integer> frames(List<Place> places) {
        List<Integer> kept = new ArrayList<>(List.of(0));
        int from = 0;
        for (int to = 2; to < places.size(); to++) {
            if (!isEven(places, from, to)) {
                from = to - 1;
                kept.add(from);
            }
        }
        if (places.size() > 1) {
            kept.add(places.size() - 1);
        }
        return kept;
    }

    private static boolean isEven(List<Place> places, int from, int to) {
        for (int i = from + 1; i < to; i++) {
            double part = (double) (i - from) / (to - from);
            if (isOff(places, from, i, to, part, Place::x)
                    || isOff(places, from, i, to, part, Place::y)
                    || isOff(places, from, i, to, part, Place::turned)) {
                return false;
            }
        }
        return true;
    }

    private static boolean isOff(
            List<Place> places, int from, int i, int to, double part, ToDoubleFunction<Place> of) {
        double begin = of.applyAsDouble(places.get(from));
        double end = of.applyAsDouble(places.get(to));
        return Math.abs(begin + part * (end - begin) - of.applyAsDouble(places.get(i))) > NEAR;
    }
}
