package arcomat.report.world;

import arcomat.diagram.Theme;
import arcomat.report.page.SelfContained;
import arcomat.world.Device;
import arcomat.world.Recording;
import arcomat.world.Recording.RobotFrame;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Segment;
import arcomat.world.World;
import arcomat.world.World.Cup;
import arcomat.world.World.Robot;

import java.util.List;
import java.util.Locale;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * A run of a world as one picture in SVG that moves, as pages of other people can show it: it loads
 * nothing and has no script. Who does not want things to move sees where all began.
 */
public final class WorldAnimation {
    private static final List<String> STYLES =
            List.of("colours.css", "replay/floor.css", "replay/animation.css");

    /** Around the floor, in mm. */
    private static final int MARGIN = 40;

    private static final int CUP_RADIUS = 28;

    private static final int DRINKER_RADIUS = 100;

    /** So many frames a collision is seen. */
    private static final int SEEN = 1000 / Recording.PERIOD;

    private final Recording recording;
    private final World world;
    private final Keyframes keyframes;
    private final StringBuilder shapes = new StringBuilder();

    private WorldAnimation(Recording recording) {
        this.recording = recording;
        this.world = recording.world();
        this.keyframes = new Keyframes(recording.frames().size());
    }

    /**
     * @param title what ran, such as the name of the world's file
     */
    public static String render(Recording recording, String title) {
        return new WorldAnimation(recording).document(title);
    }

    private String document(String title) {
        add("<g class=\"lines\">");
        world.lines().forEach(line -> outline(line.pieces(), "line", line.width()));
        add("</g>");
        world.walls().forEach(wall -> outline(List.of(wall), "wall", 0));
        world.drinkers().forEach(this::drinker);
        IntStream.range(0, world.things().size()).forEach(this::thing);
        IntStream.range(0, world.robots().size()).forEach(this::robot);
        double seconds = Keyframes.seconds(recording.duration());
        return """
        <svg xmlns="http://www.w3.org/2000/svg" class="arcomat floor" role="img" viewBox="%d %d %s %s">
        <title>%s</title>
        <desc>%s</desc>
        <style>
        %s.floor * { animation-duration: %ss; }
        %s</style>
        %s</svg>
        """
                .formatted(
                        -MARGIN,
                        -MARGIN,
                        number(world.width() + 2 * MARGIN),
                        number(world.depth() + 2 * MARGIN),
                        SelfContained.escaped(title),
                        SelfContained.escaped(WorldText.summary(recording)),
                        Theme.ADAPTIVE.css() + SelfContained.join(STYLES),
                        number(seconds),
                        keyframes.css(),
                        shapes);
    }

    /** The world's y grows upwards, that of pictures downwards. */
    private double down(double y) {
        return world.depth() - y;
    }

    private void outline(List<Segment> pieces, String kind, double width) {
        StringBuilder points =
                new StringBuilder(point(pieces.get(0).from().x(), pieces.get(0).from().y()));
        pieces.forEach(piece -> points.append(' ').append(point(piece.to().x(), piece.to().y())));
        String thick = width > 0 ? " stroke-width=\"" + number(width) + "\"" : "";
        add("<polyline class=\"%s\"%s points=\"%s\"/>", kind, thick, points);
    }

    private String point(double x, double y) {
        return number(x) + "," + number(down(y));
    }

    private void drinker(World.Drinker drinker) {
        String x = number(drinker.spot().x());
        double y = down(drinker.spot().y());
        add(
                "<circle class=\"drinker\" cx=\"%s\" cy=\"%s\" r=\"%d\"/>",
                x, number(y), DRINKER_RADIUS);
        add(
                "<text x=\"%s\" y=\"%s\">%s</text>",
                x, number(y + 20), SelfContained.escaped(drinker.name()));
    }

    private void thing(int which) {
        World.Thing thing = world.things().get(which);
        List<Motion.Place> places =
                recording.frames().stream()
                        .map(frame -> frame.things().get(which))
                        .map(place -> new Motion.Place(place.x(), down(place.y()), 0))
                        .toList();
        add("<g%s>", keyframes.moving(places));
        add("<circle class=\"thing\" r=\"%s\"/>", number(thing.radius()));
        add("<text y=\"20\">%s</text>", SelfContained.escaped(thing.name()));
        add("</g>");
    }

    /** Drawn around (0, 0) with the front to the right; then moved and turned as a whole. */
    private void robot(int which) {
        Robot robot = world.robots().get(which);
        double radius = robot.kind().radius();
        List<Motion.Place> places =
                IntStream.range(0, recording.frames().size())
                        .mapToObj(i -> place(frame(i, which)))
                        .toList();
        boolean drives = robot.kind().wheels().isPresent();
        add("<g class=\"%s\"%s>", drives ? "robot" : "robot station", keyframes.turning(places));
        add("<circle class=\"body\" r=\"%s\"/>", number(radius));
        if (drives) {
            wheel(-0.7 * radius, radius);
            wheel(0.7 * radius, radius);
            add(
                    "<path class=\"nose\" d=\"M%1$s -%1$sL%2$s 0L%1$s %1$s\"/>",
                    number(0.35 * radius), number(0.85 * radius));
        }
        robot.kind().sensors().stream()
                .filter(Device.Light.class::isInstance)
                .map(Device.Light.class::cast)
                .forEach(
                        eye ->
                                add(
                                        "<circle class=\"eye dark\" cx=\"%s\" cy=\"%s\" r=\"9\"/>",
                                        number(eye.place().x()), number(-eye.place().y())));
        for (Cup cup : List.of(Cup.EMPTY, Cup.FULL)) {
            String kind = "cup " + cup.name().toLowerCase(Locale.ROOT);
            circleWhile(i -> frame(i, which).cup() == cup, kind, CUP_RADIUS);
        }
        circleWhile(i -> collides(robot.name(), i), "collision", radius + 25);
        add("</g>");
        label(robot, which, places);
    }

    private RobotFrame frame(int number, int robot) {
        return recording.frames().get(number).robots().get(robot);
    }

    private Motion.Place place(RobotFrame robot) {
        return new Motion.Place(
                robot.pose().x(), down(robot.pose().y()), -Math.toDegrees(robot.pose().heading()));
    }

    private boolean collides(String robot, int frame) {
        int time = recording.frames().get(frame).time();
        return recording.events().stream()
                .anyMatch(
                        event ->
                                event instanceof Recording.Event.Happened happened
                                        && happened.happening().what() == What.COLLISION
                                        && happened.happening().who().equals(robot)
                                        && event.time() <= time
                                        && time < event.time() + SEEN * Recording.PERIOD);
    }

    private void wheel(double y, double radius) {
        add(
                "<rect class=\"wheel\" x=\"%s\" y=\"%s\" width=\"%s\" height=\"16\" rx=\"4\"/>",
                number(-0.35 * radius), number(y - 8), number(0.7 * radius));
    }

    private void circleWhile(IntPredicate isSeen, String kind, double radius) {
        keyframes
                .seenWhile(isSeen)
                .ifPresent(
                        seen ->
                                add(
                                        "<circle class=\"%s\"%s r=\"%s\"/>",
                                        kind, seen, number(radius)));
    }

    /** Above and below in turn: two that meet have both names to be read. */
    private void label(Robot robot, int which, List<Motion.Place> places) {
        double radius = robot.kind().radius();
        boolean above = which % 2 == 0;
        add("<g%s>", keyframes.moving(places));
        add(
                "<text y=\"%s\">%s</text>",
                number(above ? -radius - 84 : radius + 70), SelfContained.escaped(robot.name()));
        String y = number(above ? -radius - 24 : radius + 130);
        List<String> displays =
                IntStream.range(0, recording.frames().size())
                        .mapToObj(i -> frame(i, which).display())
                        .toList();
        for (String display :
                displays.stream().distinct().filter(each -> !each.isBlank()).toList()) {
            keyframes
                    .seenWhile(i -> displays.get(i).equals(display))
                    .ifPresent(
                            seen ->
                                    add(
                                            "<text class=\"doing\"%s y=\"%s\">%s</text>",
                                            seen, y, SelfContained.escaped(display)));
        }
        add("</g>");
    }

    private void add(String form, Object... parts) {
        shapes.append(form.formatted(parts)).append('\n');
    }

    /** Rounded to what can be seen. */
    static String number(double value) {
        return String.format(Locale.ROOT, "%.1f", value == 0 ? 0.0 : value).replaceAll("\\.0$", "");
    }
}
