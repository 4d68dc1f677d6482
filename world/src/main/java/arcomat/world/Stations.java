package arcomat.world;

import arcomat.world.Scene.Happening;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Scene.RobotState;
import arcomat.world.World.Cup;

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

    /** What does something to cups, by robot: most robots have none of it. */
    private final List<List<Device>> arms;

    Stations(World world) {
        this.world = world;
        this.arms = world.robots().stream().map(robot -> arms(robot.kind())).toList();
    }

    private static List<Device> arms(Kind kind) {
        return kind.devices().stream()
                .filter(each -> each instanceof Device.Slide || each instanceof Device.Finger)
                .toList();
    }

    void step(
            List<RobotState> robots,
            double[][] shafts,
            double seconds,
            List<Happening> happenings) {
        for (int i = 0; i < robots.size(); i++) {
            for (Device device : arms.get(i)) {
                if (device instanceof Device.Slide slide) {
                    double way = shafts[i][slide.motor() - 1] * seconds;
                    int stock = robots.get(i).stock();
                    if (turn(i, way, robots) && stock > 0) {
                        robots.set(i, robots.get(i).supplied(stock - 1, 0));
                        give(Gift.CUP, i, robots, happenings);
                    }
                } else if (device instanceof Device.Finger finger) {
                    brew(i, seconds, robots, happenings);
                    double way = shafts[i][finger.motor() - 1] * seconds;
                    if (turn(i, way, robots) && robots.get(i).brewing() == 0) {
                        RobotState state = robots.get(i);
                        robots.set(i, state.supplied(state.stock(), finger.seconds()));
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
        robots.set(index, state.turned(angle, out));
        return reached;
    }

    private void brew(
            int index, double seconds, List<RobotState> robots, List<Happening> happenings) {
        RobotState state = robots.get(index);
        if (state.brewing() > 0) {
            double left = Math.max(0, state.brewing() - seconds);
            robots.set(index, state.supplied(state.stock(), left));
            if (left == 0) {
                give(Gift.COFFEE, index, robots, happenings);
            }
        }
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
