package arcomat.world;

import arcomat.world.Scene.RobotState;
import arcomat.world.World.Robot;

import java.util.List;

/**
 * How close robots have come to each other and to what stands or lies around them, over a run.
 * Measured a hundred times a second of the run.
 */
final class Clearance {
    private final World world;
    private final boolean[] drives;
    private double apart = Double.POSITIVE_INFINITY;
    private double clear = Double.POSITIVE_INFINITY;

    Clearance(World world) {
        this.world = world;
        drives = new boolean[world.robots().size()];
        for (int i = 0; i < drives.length; i++) {
            drives[i] = world.robots().get(i).kind().wheels().isPresent();
        }
    }

    /** As {@link Summary#apart()}. */
    double apart() {
        return apart;
    }

    /** As {@link Summary#clear()}. */
    double clear() {
        return clear;
    }

    void measure(Scene scene) {
        for (int i = 0; i < drives.length; i++) {
            if (drives[i]) {
                measureToOthers(i, scene.robots());
                measureToSurroundings(i, scene);
            }
        }
    }

    /** Two that drive are measured once. */
    private void measureToOthers(int index, List<RobotState> robots) {
        Pose pose = robots.get(index).pose();
        for (int other = 0; other < robots.size(); other++) {
            if (other > index || !drives[other]) {
                Pose its = robots.get(other).pose();
                double bodies = radius(index) + radius(other);
                apart = Math.min(apart, pose.distance(its.x(), its.y()) - bodies);
            }
        }
    }

    private void measureToSurroundings(int index, Scene scene) {
        Pose pose = scene.robots().get(index).pose();
        double nearest = Double.POSITIVE_INFINITY;
        for (Segment wall : world.walls()) {
            nearest = Math.min(nearest, wall.distance(pose.x(), pose.y()));
        }
        for (int i = 0; i < scene.drinkers().size(); i++) {
            if (scene.drinkers().get(i).present()) {
                Disc legs = world.drinkers().get(i).legs();
                Point centre = legs.centre();
                nearest = Math.min(nearest, pose.distance(centre.x(), centre.y()) - legs.radius());
            }
        }
        for (int i = 0; i < scene.things().size(); i++) {
            Point middle = scene.things().get(i).place();
            double radius = world.things().get(i).radius();
            nearest = Math.min(nearest, pose.distance(middle.x(), middle.y()) - radius);
        }
        clear = Math.min(clear, Math.min(nearest - radius(index), toEdge(pose)));
    }

    private double toEdge(Pose pose) {
        double across = Math.min(pose.x(), world.width() - pose.x());
        double along = Math.min(pose.y(), world.depth() - pose.y());
        return Math.min(across, along);
    }

    private double radius(int index) {
        Robot robot = world.robots().get(index);
        return robot.kind().radius();
    }
}
