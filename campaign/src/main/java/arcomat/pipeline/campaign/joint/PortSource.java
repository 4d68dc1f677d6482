package arcomat.pipeline.campaign.joint;

import arcomat.campaign.JointWatch.RobotPort;
import arcomat.model.Value;
import arcomat.pipeline.campaign.measure.MeasuredExpression;
import arcomat.world.World;

import org.jspecify.annotations.Nullable;

import java.util.Map;
import java.util.Optional;

/**
 * What a port of a requirement shows.
 *
 * @param robot whose slices it shows; empty if it shows something at every moment
 */
record PortSource(Optional<String> robot, Reader reader) {
    /** Reads a message. */
    interface Reader {
        /**
         * Null where there is none.
         *
         * @param slice of those that have ended since the moment before, from 0
         * @throws ForeignValue where it is no value of the port
         */
        @Nullable Object read(int slice, WorldMoment moment) throws ForeignValue;
    }

    /** Of a robot's port; empty where the world does not have the robot. */
    static Optional<PortSource> of(RobotPort port, Map<String, ProgramTaps> robots) {
        String robot = port.robot();
        return Optional.ofNullable(robots.get(robot))
                .map(taps -> taps.index(port.path()))
                .map(
                        tap ->
                                new PortSource(
                                        Optional.of(robot),
                                        (slice, moment) -> moment.shown(robot, slice, tap)));
    }

    /** Of an expression; empty where the world does not have all of it. */
    static Optional<PortSource> of(MeasuredExpression expression, World world) {
        MeasuredExpression.InWorld there = expression.in(world);
        return there.isWhole()
                ? Optional.of(
                        new PortSource(
                                Optional.empty(),
                                (slice, moment) -> read(expression, there, moment)))
                : Optional.empty();
    }

    private static @Nullable Object read(
            MeasuredExpression expression, MeasuredExpression.InWorld there, WorldMoment moment)
            throws ForeignValue {
        Value value = there.read(moment.scene(), moment.instruments());
        if (value == null) {
            return null;
        }
        if (!expression.type().has(value)) {
            throw new ForeignValue("%s is no %s".formatted(value, expression.type().name()));
        }
        return new FieldValue(expression.type()).of(value);
    }
}
