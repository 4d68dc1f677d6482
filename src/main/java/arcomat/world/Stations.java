package arcomat.world;

import arcomat.world.Happening.What;
import arcomat.world.Scene.RobotState;

import java.util.List;
import java.util.OptionalInt;

/** What slides and fingers do to cups. */
final class Stations {
    /** Degrees after which a slide has pushed a cup out, or a finger has pressed its button. */
    private static final double OUT = 30;

    /** Degrees below which it is back. */
    private static final double BACK = 15;

    /** Degrees at which it meets its stop, and the motor's clutch slips; the other stop is at 0. */
    private static final double STOP = 45;

    /**
     * What comes out of a station.
     *
     * @param mouth where
     * @param before what is in the holder of a robot that can take it
     * @param after what is in there then
     * @param given what has happened if such a robot is there
     * @param lost what has happened if there is none
     */
    private record Gift(
            Class<? extends Device.Placed> mouth, Cup before, Cup after, What given, What lost) {
        static final Gift CUP =
                new Gift(Device.Chute.class, Cup.NONE, Cup.EMPTY, What.CUP_GIVEN, What.CUP_LOST);
        static final Gift COFFEE =
                new Gift(
                        Device.Feeler.class,
                        Cup.EMPTY,
                        Cup.FULL,
                        What.COFFEE_POURED,
                        What.COFFEE_SPILT);
    }

    private final World world;

    Stations(World world) {
        this.world = world;
    }

    void step(
            List<RobotState> robots,
            double[][] shafts,
            double seconds,
            List<Happening> happenings) {
        for (int i = 0; i < robots.size(); i++) {
            Kind kind = world.robots().get(i).kind();
            for (Device device : kind.devices()) {
                if (device instanceof Device.Slide slide) {
                    double way = shafts[i][slide.motor() - 1] * seconds;
                    if (turn(i, way, robots) && robots.get(i).stock() > 0) {
                        drop(i, robots, happenings);
                    }
                } else if (device instanceof Device.Finger finger) {
                    brew(i, seconds, robots, happenings);
                    double way = shafts[i][finger.motor() - 1] * seconds;
                    if (turn(i, way, robots) && robots.get(i).brewing() == 0) {
                        supply(i, robots.get(i).stock(), finger.seconds(), robots);
                    }
                }
            }
        }
    }

    /** Whether the arm reaches its end in this step. */
    private static boolean turn(int index, double way, List<RobotState> robots) {
        RobotState state = robots.get(index);
        double angle = Math.max(0, Math.min(STOP, state.angle() + way));
        boolean reached = !state.turnedOut() && angle >= OUT;
        boolean out = reached || state.turnedOut() && angle >= BACK;
        robots.set(
                index,
                new RobotState(
                        state.pose(),
                        state.left(),
                        state.right(),
                        state.touching(),
                        state.cup(),
                        angle,
                        out,
                        state.stock(),
                        state.brewing()));
        return reached;
    }

    private static void supply(int index, int stock, double brewing, List<RobotState> robots) {
        RobotState state = robots.get(index);
        robots.set(
                index,
                new RobotState(
                        state.pose(),
                        state.left(),
                        state.right(),
                        state.touching(),
                        state.cup(),
                        state.angle(),
                        state.turnedOut(),
                        stock,
                        brewing));
    }

    private void drop(int index, List<RobotState> robots, List<Happening> happenings) {
        supply(index, robots.get(index).stock() - 1, 0, robots);
        give(Gift.CUP, index, robots, happenings);
    }

    private void brew(
            int index, double seconds, List<RobotState> robots, List<Happening> happenings) {
        RobotState state = robots.get(index);
        if (state.brewing() == 0) {
            return;
        }
        double left = Math.max(0, state.brewing() - seconds);
        supply(index, state.stock(), left, robots);
        if (left > 0) {
            return;
        }
        give(Gift.COFFEE, index, robots, happenings);
    }

    private void give(Gift gift, int index, List<RobotState> robots, List<Happening> happenings) {
        Point place = mouth(index, gift.mouth(), robots);
        OptionalInt receiver = below(place, gift.before(), robots);
        String giver = world.robots().get(index).name();
        if (receiver.isPresent()) {
            int lucky = receiver.getAsInt();
            robots.set(lucky, robots.get(lucky).with(gift.after()));
            String name = world.robots().get(lucky).name();
            happenings.add(new Happening(gift.given(), name, giver));
        } else {
            happenings.add(new Happening(gift.lost(), giver, ""));
        }
    }

    private Point mouth(int index, Class<? extends Device.Placed> type, List<RobotState> robots) {
        Pose pose = robots.get(index).pose();
        return world.robots()
                .get(index)
                .kind()
                .find(type)
                .map(device -> pose.place(device.place()))
                .orElse(pose.point());
    }

    /** The robot that holds such a cup, or room for one, below a place. */
    private OptionalInt below(Point place, Cup cup, List<RobotState> robots) {
        for (int i = 0; i < robots.size(); i++) {
            RobotState state = robots.get(i);
            if (state.cup() == cup && world.robots().get(i).kind().holdsAt(state.pose(), place)) {
                return OptionalInt.of(i);
            }
        }
        return OptionalInt.empty();
    }
}
