package arcomat.world;

import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.world.World.Drinker;
import arcomat.world.World.Robot;
import arcomat.world.World.Thing;

import java.util.ArrayList;
import java.util.List;

/** The laws about where things are: on the floor, and no two bodies in one place. */
final class Placement {
    private static final String OUTSIDE = "ARC1122";
    private static final String OCCUPIED = "ARC1124";

    private final World world;
    private final List<Diagnostic> findings = new ArrayList<>();

    private Placement(World world) {
        this.world = world;
    }

    static List<Diagnostic> check(World world, List<WorldParser.Stripe> stripes) {
        Placement placement = new Placement(world);
        stripes.forEach(placement::stripe);
        world.robots().forEach(placement::robot);
        world.drinkers().forEach(placement::drinker);
        world.things().forEach(placement::thing);
        return placement.findings;
    }

    private void stripe(WorldParser.Stripe stripe) {
        String what = stripe.isWall() ? "wall" : "line";
        stripe.points().stream()
                .filter(point -> !world.contains(point))
                .findFirst()
                .ifPresent(
                        point ->
                                outside(
                                        stripe.place(),
                                        "this " + what + " leaves",
                                        "%s is beside it",
                                        point));
    }

    private void robot(Robot robot) {
        String name = "robot '" + robot.name() + "'";
        body(name, robot.disc(), robot.place());
        for (Robot other : world.robots()) {
            if (other == robot) {
                break;
            }
            if (robot.disc().overlaps(other.disc())) {
                String both = "robots '%s' and '%s'".formatted(robot.name(), other.name());
                occupied(robot.place(), both, other.name(), other.place());
            }
        }
    }

    private void thing(Thing thing) {
        String name = "thing '" + thing.name() + "'";
        Disc disc = thing.at(thing.spot());
        body(name, disc, thing.place());
        for (Robot robot : world.robots()) {
            if (disc.overlaps(robot.disc())) {
                String both = name + " and robot '" + robot.name() + "'";
                occupied(thing.place(), both, robot.name(), robot.place());
            }
        }
        for (Thing other : world.things()) {
            if (other == thing) {
                break;
            }
            if (disc.overlaps(other.at(other.spot()))) {
                String both = "things '%s' and '%s'".formatted(thing.name(), other.name());
                occupied(thing.place(), both, other.name(), other.place());
            }
        }
    }

    /** On the floor, and in no wall. */
    private void body(String name, Disc disc, Span place) {
        if (!world.contains(disc)) {
            String shape =
                    "%s, of radius %d, reaches over the edge of"
                            .formatted(name, Math.round(disc.radius()));
            outside(place, shape, "it stands at %s", disc.centre());
        }
        if (world.walls().stream().anyMatch(disc::overlaps)) {
            findings.add(Diagnostic.error(OCCUPIED, place, name + " stands in a wall"));
        }
    }

    private void drinker(Drinker drinker) {
        if (!world.contains(drinker.spot())) {
            String who = "drinker '" + drinker.name() + "' stands beside";
            outside(drinker.place(), who, "%s is beside it", drinker.spot());
        }
    }

    private void outside(Span place, String what, String where, Point point) {
        String floor =
                "the floor of %d x %d mm"
                        .formatted(Math.round(world.width()), Math.round(world.depth()));
        String at = "(%d, %d)".formatted(Math.round(point.x()), Math.round(point.y()));
        String message = what + " " + floor + ": " + where.formatted(at);
        findings.add(Diagnostic.error(OUTSIDE, place, message));
    }

    private void occupied(Span place, String both, String other, Span otherPlace) {
        findings.add(
                Diagnostic.error(OCCUPIED, place, both + " are in one place: their bodies overlap")
                        .withRelated(otherPlace, "'" + other + "' stands here"));
    }
}
