package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Quantity;
import arcomat.world.Summary;

import java.util.Arrays;
import java.util.List;

/** What a run answers to what every campaign asks. */
final class Answers {
    private static final double MILLISECONDS = 1000;

    private Answers() {}

    /**
     * In the order of {@link Quantity}.
     *
     * @param transitions how many were taken; not a number where nobody knows
     */
    static List<Double> of(Summary run, double transitions) {
        return Arrays.stream(Quantity.values())
                .map(each -> answer(each, run, transitions))
                .toList();
    }

    private static double answer(Quantity asked, Summary run, double transitions) {
        double seconds = run.duration() / MILLISECONDS;
        return switch (asked) {
            case COLLISION -> truth(run.collisions() > 0);
            case DEADLOCK -> truth(run.stillSince().isPresent());
            case FAILURE -> truth(!run.failures().isEmpty());
            case GOAL -> truth(run.goalReached());
            case TIME -> seconds;
            case REACHED -> run.goalReached() ? seconds : Double.POSITIVE_INFINITY;
            case DELIVERED -> run.delivered();
            case DISTANCE -> finite(run.apart());
            case CLEARANCE -> finite(run.clear());
            case LATE -> run.lateSlices();
            case TRANSITIONS -> transitions;
        };
    }

    private static double truth(boolean so) {
        return so ? 1 : 0;
    }

    /** Where there is nothing to be near to, there is no distance. */
    private static double finite(double millimetres) {
        return Double.isInfinite(millimetres) ? Double.NaN : rounded(millimetres);
    }

    /** To a thousandth of a millimetre: more is noise of the arithmetic to whoever reads it. */
    private static double rounded(double millimetres) {
        return Math.rint(millimetres * 1000) / 1000;
    }
}
