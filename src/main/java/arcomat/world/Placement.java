package arcomat.world;

import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.world.World.Drinker;
import arcomat.world.World.Robot;

import java.util.ArrayList;
import java.util.List;

/** The laws about where things are: on the floor, and no two robots in one place. */
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
        if (!world.contains(robot.disc())) {
            String shape =
                    "robot '%s', of radius %d, reaches over the edge of"
                            .formatted(robot.name(), Math.round(robot.kind().radius()));
            outside(robot.place(), shape, "it stands at %s", robot.pose().point());
        }
        for (Robot other : world.robots()) {
            if (other == robot) {
                break;
            }
            if (robot.disc().overlaps(other.disc())) {
                occupied(robot.place(), robot.name(), other.name(), other.place());
            }
        }
        if (world.walls().stream().anyMatch(robot.disc()::overlaps)) {
            findings.add(
                    Diagnostic.error(
                            OCCUPIED,
                            robot.place(),
                            "robot '" + robot.name() + "' stands in a wall"));
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

    private void occupied(Span place, String name, String other, Span otherPlace) {
        findings.add(
                Diagnostic.error(
                                OCCUPIED,
                                place,
                                "robots '%s' and '%s' are in one place: their bodies overlap"
                                        .formatted(name, other))
                        .withRelated(otherPlace, "'" + other + "' stands here"));
    }
}
