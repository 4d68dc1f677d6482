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

    /** How far a holder may be from where a cup drops or coffee runs, in mm. */
    static final double TOLERANCE = 60;

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
        Point place = mouth(index, Device.Chute.class, robots);
        OptionalInt receiver = below(place, Cup.NONE, robots);
        String dispenser = world.robots().get(index).name();
        if (receiver.isPresent()) {
            int lucky = receiver.getAsInt();
            robots.set(lucky, robots.get(lucky).with(Cup.EMPTY));
            String name = world.robots().get(lucky).name();
            happenings.add(new Happening(What.CUP_GIVEN, name, dispenser));
        } else {
            happenings.add(new Happening(What.CUP_LOST, dispenser, ""));
        }
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
        Point place = mouth(index, Device.Feeler.class, robots);
        OptionalInt receiver = below(place, Cup.EMPTY, robots);
        String preparer = world.robots().get(index).name();
        if (receiver.isPresent()) {
            int lucky = receiver.getAsInt();
            robots.set(lucky, robots.get(lucky).with(Cup.FULL));
            String name = world.robots().get(lucky).name();
            happenings.add(new Happening(What.COFFEE_POURED, name, preparer));
        } else {
            happenings.add(new Happening(What.COFFEE_SPILT, preparer, ""));
        }
    }

    private <D extends Device> Point mouth(int index, Class<D> type, List<RobotState> robots) {
        Pose pose = robots.get(index).pose();
        return world.robots()
                .get(index)
                .kind()
                .find(type)
                .map(device -> pose.place(placeOf(device)))
                .orElse(pose.point());
    }

    private static Point placeOf(Device device) {
        return device instanceof Device.Chute chute
                ? chute.place()
                : ((Device.Feeler) device).place();
    }

    /** The robot that holds such a cup, or room for one, below a place. */
    private OptionalInt below(Point place, Cup cup, List<RobotState> robots) {
        for (int i = 0; i < robots.size(); i++) {
            RobotState state = robots.get(i);
            Pose pose = state.pose();
            boolean near =
                    world.robots()
                            .get(i)
                            .kind()
                            .find(Device.Holder.class)
                            .map(holder -> pose.place(holder.place()).distance(place) <= TOLERANCE)
                            .orElse(false);
            if (near && state.cup() == cup) {
                return OptionalInt.of(i);
            }
        }
        return OptionalInt.empty();
    }
}
