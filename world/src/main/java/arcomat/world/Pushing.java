package arcomat.world;

import arcomat.world.Scene.DrinkerState;
import arcomat.world.Scene.Happening;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Scene.RobotState;
import arcomat.world.Scene.ThingState;
import arcomat.world.World.Robot;
import arcomat.world.World.Thing;
import arcomat.world.arithmetic.Circle;
import arcomat.world.contact.Body;
import arcomat.world.contact.Contact;
import arcomat.world.contact.Contacts;
import arcomat.world.contact.Crowd;
import arcomat.world.contact.Rolling;
import arcomat.world.contact.Round;
import arcomat.world.contact.Sliding;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

/**
 * What is done to things that lie on the floor: robots push them, and they push each other and
 * robots. Walls, people, robots without wheels and the edge of the floor stop them.
 */
final class Pushing {
    /** In mm per second, in each second. */
    private static final double GRAVITY = 9810;

    /** What is farther away than this, in mm, is not reached in one step. */
    private static final double REACH = 100;

    /** A robot that has pushed a thing still does while it is less than this away, in mm. */
    private static final double STILL = 5;

    private final World world;
    private final double seconds;

    /**
     * @param seconds of a step
     */
    Pushing(World world, double seconds) {
        this.world = world;
        this.seconds = seconds;
    }

    /** Things before the first step. */
    static List<ThingState> start(World world) {
        return world.things().stream().map(each -> new ThingState(each.spot(), 0, 0)).toList();
    }

    /**
     * What things and robots do after they met; robots are given the speeds that they keep.
     *
     * @param before where robots and things still are
     * @param robots with the speeds to which their wheels have pulled them
     * @param shafts as {@link Physics#step} has them
     */
    Meeting meet(
            Scene before, List<RobotState> robots, double[][] shafts, List<Happening> happenings) {
        if (world.things().isEmpty()) {
            return new Meeting(List.of(), List.of(), Collections.nCopies(robots.size(), 0.0));
        }
        Step step = new Step(before, robots, shafts);
        step.contacts.settle();
        for (int i = 0; i < robots.size(); i++) {
            robots.set(i, step.robot(i, robots.get(i), happenings));
        }
        List<ThingState> things = step.states();
        List<Double> speeds = step.speeds();
        step.contacts.part();
        return new Meeting(things, step.states(), differences(step.speeds(), speeds));
    }

    private static List<Double> differences(List<Double> ones, List<Double> others) {
        return IntStream.range(0, ones.size()).mapToObj(i -> ones.get(i) - others.get(i)).toList();
    }

    /**
     * Things where their speeds take them. Who would come to where another one is, since there was
     * no room for all of them, is held.
     *
     * @param before where robots and things were
     * @param robots where they are now
     * @param meeting what has come of it
     */
    List<ThingState> move(Scene before, List<RobotState> robots, Meeting meeting) {
        List<ThingState> things = meeting.things();
        if (things.isEmpty()) {
            return things;
        }
        Crowd crowd = crowd(before, robots, meeting.moving());
        crowd.settle();
        for (int i = 0; i < robots.size(); i++) {
            robots.set(i, held(robots.get(i), crowd.now(i)));
        }
        List<ThingState> moved = new ArrayList<>();
        for (int i = 0; i < things.size(); i++) {
            moved.add(moved(things.get(i), crowd, robots.size() + i));
        }
        return moved;
    }

    /** Those of robots, then those of things. */
    private Crowd crowd(Scene before, List<RobotState> robots, List<ThingState> things) {
        Crowd crowd = new Crowd();
        for (int i = 0; i < robots.size(); i++) {
            crowd.add(round(i, before.robots().get(i)), round(i, robots.get(i)));
        }
        for (int i = 0; i < things.size(); i++) {
            ThingState thing = things.get(i);
            Point to = thing.place().plus(thing.along() * seconds, thing.across() * seconds);
            crowd.add(round(i, thing.place()), round(i, to));
            if (isBlocked(world.things().get(i).at(to), before.drinkers())) {
                crowd.hold(robots.size() + i);
            }
        }
        return crowd;
    }

    private static RobotState held(RobotState robot, Round place) {
        Pose pose = robot.pose();
        if (place.x() == pose.x() && place.y() == pose.y()) {
            return robot;
        }
        Pose held = new Pose(place.x(), place.y(), pose.heading());
        return robot.moved(held, 0, 0, robot.touching());
    }

    private static ThingState moved(ThingState thing, Crowd crowd, int index) {
        Point place = new Point(crowd.now(index).x(), crowd.now(index).y());
        return crowd.isHeld(index)
                ? new ThingState(place, 0, 0)
                : new ThingState(place, thing.along(), thing.across());
    }

    /** Whether something that nobody moves is there. */
    private boolean isBlocked(Disc disc, List<DrinkerState> drinkers) {
        for (int i = 0; i < drinkers.size(); i++) {
            if (drinkers.get(i).present() && disc.overlaps(world.drinkers().get(i).legs())) {
                return true;
            }
        }
        return world.walls().stream().anyMatch(disc::overlaps) || !world.contains(disc.centre());
    }

    private Round round(int robot, RobotState state) {
        double radius = world.robots().get(robot).kind().radius();
        return new Round(state.pose().x(), state.pose().y(), radius);
    }

    private Round round(int thing, Point place) {
        return new Round(place.x(), place.y(), world.things().get(thing).radius());
    }

    private static double speed(RobotState robot) {
        return (robot.left() + robot.right()) / 2;
    }

    /**
     * What has come of a step. Those that were too near each other go apart in it faster than they
     * go on.
     *
     * @param things with the speeds that they keep
     * @param moving things with the speeds at which they move in this step
     * @param partings by how much robots move faster in this step, in mm per second
     */
    record Meeting(List<ThingState> things, List<ThingState> moving, List<Double> partings) {}

    /** A thing while it meets others. */
    private record Thrust(Round round, Sliding body) {
        ThingState state() {
            return new ThingState(new Point(round.x(), round.y()), body.along(), body.across());
        }
    }

    /**
     * A robot near a thing.
     *
     * @param nearing how fast the robot goes there by itself, in mm per second
     */
    private record Touch(int robot, Thing thing, double gap, double nearing, Contact contact) {
        boolean isPush(boolean before) {
            return before ? gap < STILL : nearing > 0 && contact.pushes();
        }
    }

    /** Who meets whom in one step. */
    private final class Step {
        private final Scene before;
        private final Contacts contacts = new Contacts(seconds);
        private final List<Body> robots = new ArrayList<>();
        private final List<Thrust> things = new ArrayList<>();
        private final List<Touch> touches = new ArrayList<>();

        Step(Scene before, List<RobotState> pulled, double[][] shafts) {
            this.before = before;
            for (int i = 0; i < pulled.size(); i++) {
                robots.add(body(world.robots().get(i), pulled.get(i), shafts[i]));
            }
            for (int i = 0; i < world.things().size(); i++) {
                add(i, world.things().get(i));
            }
        }

        private Body body(Robot robot, RobotState state, double[] shafts) {
            return robot.kind()
                    .wheels()
                    .<Body>map(
                            wheels -> {
                                double turn = (state.right() - state.left()) / wheels.track();
                                double way = state.pose().heading() + turn * seconds / 2;
                                double mass = robot.kind().mass() + state.cup().mass;
                                double x = Circle.cos(way);
                                double y = Circle.sin(way);
                                return state.stands() && wheels.stand(shafts)
                                        ? Rolling.held(mass, x, y, speed(state))
                                        : Rolling.free(mass, x, y, speed(state));
                            })
                    .orElse(Body.FIXED);
        }

        private void add(int index, Thing thing) {
            ThingState state = before.things().get(index);
            Thrust thrust =
                    new Thrust(
                            round(index, state.place()),
                            new Sliding(thing.mass(), state.along(), state.across()));
            contacts.hold(thrust.body(), thing.friction() * thing.mass() * GRAVITY);
            meetRobots(thing, thrust);
            things.forEach(other -> meet(thrust, other.round(), other.body()));
            meetSurroundings(thrust);
            things.add(thrust);
        }

        private void meetRobots(Thing thing, Thrust thrust) {
            for (int i = 0; i < robots.size(); i++) {
                Round robot = round(i, before.robots().get(i));
                double gap = robot.gap(thrust.round());
                if (gap < REACH) {
                    Contact contact =
                            contacts.of(robot, robots.get(i), thrust.round(), thrust.body());
                    double nearing = contact.speed();
                    touches.add(new Touch(i, thing, gap, nearing, contact));
                }
            }
        }

        private void meet(Thrust thrust, Round other, Body body) {
            if (thrust.round().gap(other) < REACH) {
                contacts.of(thrust.round(), thrust.body(), other, body);
            }
        }

        private void meetSurroundings(Thrust thrust) {
            Round round = thrust.round();
            Point middle = new Point(round.x(), round.y());
            for (int i = 0; i < before.drinkers().size(); i++) {
                if (before.drinkers().get(i).present()) {
                    Disc legs = world.drinkers().get(i).legs();
                    Point there = legs.centre();
                    meet(thrust, new Round(there.x(), there.y(), legs.radius()), Body.FIXED);
                }
            }
            for (Segment wall : world.walls()) {
                if (wall.distance(middle) - round.radius() < REACH) {
                    Point nearest = wall.nearest(middle);
                    contacts.of(round, thrust.body(), nearest.x(), nearest.y());
                }
            }
            contacts.of(thrust.body(), Body.FIXED, -1, 0, round.x());
            contacts.of(thrust.body(), Body.FIXED, 1, 0, world.width() - round.x());
            contacts.of(thrust.body(), Body.FIXED, 0, -1, round.y());
            contacts.of(thrust.body(), Body.FIXED, 0, 1, world.depth() - round.y());
        }

        List<ThingState> states() {
            return things.stream().map(Thrust::state).toList();
        }

        /** Of robots, the way that they roll; 0 of those that do not. */
        List<Double> speeds() {
            return robots.stream()
                    .map(body -> body instanceof Rolling rolling ? rolling.speed() : 0.0)
                    .toList();
        }

        /** With the speeds that things have left to it; it tells of the first that it pushes. */
        RobotState robot(int index, RobotState state, List<Happening> happenings) {
            List<Touch> pushed =
                    touches.stream()
                            .filter(touch -> touch.robot() == index)
                            .filter(touch -> touch.isPush(state.pushing()))
                            .toList();
            Robot robot = world.robots().get(index);
            if (!pushed.isEmpty() && !state.pushing()) {
                String name = pushed.get(0).thing().name();
                happenings.add(new Happening(What.PUSH, robot.name(), name));
            }
            double more = 0;
            if (robots.get(index) instanceof Rolling rolling) {
                more = rolling.speed() - speed(state);
            }
            return state.rolling(state.left() + more, state.right() + more)
                    .pushing(!pushed.isEmpty());
        }
    }
}
