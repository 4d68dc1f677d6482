package arcomat.live.robot;

import arcomat.model.Value;

import java.util.Optional;
import java.util.function.Function;

/**
 * {@code nxt.DifferentialDrive}. The brick computes with 32 bits, and scripts of a browser do not:
 * each result is cut to as many, so that wheels turn as fast there as here.
 */
final class Driving implements Part {
    private static final int CIRCLE = 360;

    private final Routine routine;
    private final Shaft left;
    private final Shaft right;

    /** Degrees of a wheel for one mm of way. */
    private final double degreesPerMillimetre;

    /** Degrees of the outer wheel for one degree of the robot, when it turns on the spot. */
    private final double degreesPerDegree;

    private int speed;
    private int turn;

    /**
     * @param diameter of a wheel, in mm
     * @param track from wheel to wheel, in mm
     */
    Driving(Routine routine, Shaft left, Shaft right, int diameter, int track) {
        this.routine = routine;
        this.left = left;
        this.right = right;
        degreesPerMillimetre = single(CIRCLE / single(single(Math.PI) * diameter));
        degreesPerDegree = single((double) track / diameter);
    }

    @Override
    public void act(Function<String, Optional<Value>> in) {
        Optional<Value> newSpeed = in.apply("speed");
        Optional<Value> newTurn = in.apply("turn");
        newSpeed.ifPresent(value -> speed = (int) value.whole());
        newTurn.ifPresent(value -> turn = (int) value.whole());
        if (newSpeed.isPresent() || newTurn.isPresent()) {
            double forward = single(speed * degreesPerMillimetre);
            double outward = single(turn * degreesPerDegree);
            left.turn(rounded(single(forward - outward)));
            routine.then(() -> right.turn(rounded(single(forward + outward))));
        }
    }

    private static int rounded(double degrees) {
        return (int) Math.floor(degrees + 0.5);
    }

    private static double single(double exact) {
        return Float.intBitsToFloat(Float.floatToIntBits((float) exact));
    }
}
