package arcomat.world;

import arcomat.world.Scene.DrinkerState;
import arcomat.world.Scene.Happening;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Scene.RobotState;
import arcomat.world.Scene.ThingState;
import arcomat.world.World.Cup;
import arcomat.world.World.Drinker;
import arcomat.world.arithmetic.Arc;
import arcomat.world.arithmetic.Circle;

import java.util.ArrayList;
import java.util.List;

/** What drinkers do: they see coffee come, step in its way, wait until it stands, and take it. */
final class People {
    /** They step on the line when coffee is nearer than this, in mm. */
    private static final double SIGHT = 1000;

    /** But not when it is nearer than this. */
    private static final double CARE = 550;

    /** How far they reach, from middle to middle, in mm. */
    private static final double REACH = 520;

    /** Seconds that it takes to take a cup. */
    private static final double GRASP = 1.5;

    /** Coffee that comes has the drinker before it: within this angle, in radians. */
    private static final double AHEAD = Circle.radians(60);

    private final World world;

    People(World world) {
        this.world = world;
    }

    List<DrinkerState> step(
            List<DrinkerState> drinkers,
            List<RobotState> robots,
            List<ThingState> things,
            double seconds,
            List<Happening> happenings) {
        if (drinkers.isEmpty()) {
            return drinkers;
        }
        List<DrinkerState> next = new ArrayList<>();
        for (int i = 0; i < drinkers.size(); i++) {
            Drinker drinker = world.drinkers().get(i);
            next.add(step(drinker, drinkers.get(i), robots, things, seconds, happenings));
        }
        return next;
    }

    private DrinkerState step(
            Drinker drinker,
            DrinkerState state,
            List<RobotState> robots,
            List<ThingState> things,
            double seconds,
            List<Happening> happenings) {
        double pause = Math.max(0, state.pause() - seconds);
        int coming = coming(drinker, robots);
        if (!state.present()) {
            boolean steps =
                    coming >= 0
                            && pause == 0
                            && distance(drinker, robots.get(coming)) > CARE
                            && isFree(drinker, robots, things);
            return new DrinkerState(steps, pause, 0, state.cups());
        }
        if (coming < 0) {
            return new DrinkerState(false, pause, 0, state.cups());
        }
        RobotState robot = robots.get(coming);
        if (!robot.stands() || distance(drinker, robot) > REACH) {
            return new DrinkerState(true, pause, 0, state.cups());
        }
        double taking = state.taking() + seconds;
        if (taking < GRASP) {
            return new DrinkerState(true, pause, taking, state.cups());
        }
        robots.set(coming, robot.with(Cup.NONE));
        String giver = world.robots().get(coming).name();
        happenings.add(new Happening(What.COFFEE_TAKEN, giver, drinker.name()));
        return new DrinkerState(false, drinker.thirst(), 0, state.cups() + 1);
    }

    /** The robot that brings coffee; -1 if none does. */
    private static int coming(Drinker drinker, List<RobotState> robots) {
        for (int i = 0; i < robots.size(); i++) {
            RobotState robot = robots.get(i);
            Pose pose = robot.pose();
            double direction =
                    Arc.atan2(drinker.spot().y() - pose.y(), drinker.spot().x() - pose.x());
            double aside = Circle.nearest(direction - pose.heading());
            if (robot.cup() == Cup.FULL
                    && distance(drinker, robot) < SIGHT
                    && Math.abs(aside) < AHEAD) {
                return i;
            }
        }
        return -1;
    }

    /** Nobody steps on a robot, nor on a thing. */
    private boolean isFree(Drinker drinker, List<RobotState> robots, List<ThingState> things) {
        for (int i = 0; i < robots.size(); i++) {
            Kind kind = world.robots().get(i).kind();
            if (drinker.legs().overlaps(kind.body(robots.get(i).pose()))) {
                return false;
            }
        }
        for (int i = 0; i < things.size(); i++) {
            if (drinker.legs().overlaps(world.things().get(i).at(things.get(i).place()))) {
                return false;
            }
        }
        return true;
    }

    private static double distance(Drinker drinker, RobotState robot) {
        return drinker.spot().distance(robot.pose().point());
    }
}
