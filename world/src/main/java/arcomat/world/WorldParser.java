package arcomat.world;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.world.Words.Unreadable;
import arcomat.world.World.Drinker;
import arcomat.world.World.Noise;
import arcomat.world.World.Robot;
import arcomat.world.World.Thing;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads worlds: one thing per line. docs/world.md lists what there is. */
public final class WorldParser {
    /** What a line begins with that leaves something to whoever runs a world. */
    public static final String PARAMETER = Parameters.STATEMENT;

    private static final String UNKNOWN = "ARC1123";
    private static final List<String> STATEMENTS =
            List.of(
                    Parameters.STATEMENT,
                    "floor",
                    "seconds",
                    "goal",
                    "noise",
                    "line",
                    "wall",
                    "kind",
                    "robot",
                    "robots",
                    "drinker",
                    "thing");
    private static final double LINE_WIDTH = 40;

    /** As of wood or cardboard on a floor. */
    private static final double FRICTION = 0.3;

    private static final int LONGEST = 86_400;

    private final SourceFile file;
    private final Parameters parameters;
    private final List<Diagnostic> findings = new ArrayList<>();
    private final Map<String, Word> once = new LinkedHashMap<>();
    private final Map<String, KindDraft> kinds = new LinkedHashMap<>();
    private final List<Stripe> stripes = new ArrayList<>();
    private final List<RobotDraft> robots = new ArrayList<>();
    private final List<Word> wanted = new ArrayList<>();
    private final List<Drinker> drinkers = new ArrayList<>();
    private final List<Thing> things = new ArrayList<>();
    private @Nullable KindDraft open;
    private double width;
    private double depth;
    private int seconds = 60;
    private int goal;
    private Noise noise = Noise.USUAL;

    private WorldParser(SourceFile file, Parameters parameters) {
        this.file = file;
        this.parameters = parameters;
    }

    /**
     * A world that was read.
     *
     * @param world absent if there are findings
     * @param programs of its kinds, also of those that nobody is of
     * @param findings in the order of the text
     */
    public record Parsed(
            Optional<World> world, List<Kind.Program> programs, List<Diagnostic> findings) {
        public Parsed {
            programs = List.copyOf(programs);
            findings = List.copyOf(findings);
        }
    }

    /** A line or a wall, as it is written. */
    record Stripe(
            Span place, boolean isWall, List<Point> points, List<Segment> pieces, double width) {}

    /** With the usual values of its parameters. */
    public static Parsed parse(SourceFile file) {
        return parse(file, Map.of());
    }

    /**
     * With other values of some of its parameters. Findings point at what is written.
     *
     * @param values by the names of {@link #parameters}; other names mean nothing
     */
    public static Parsed parse(SourceFile file, Map<String, String> values) {
        WorldParser parser = new WorldParser(file, Parameters.of(file, values));
        for (int line = 1; line <= file.lineCount(); line++) {
            parser.read(line);
        }
        return parser.result();
    }

    /** What a world leaves to whoever runs it, in the order of the text. */
    public static List<WorldParameter> parameters(SourceFile file) {
        return Parameters.of(file, Map.of()).all();
    }

    /**
     * The words of which one may follow.
     *
     * @param beginning of a text, up to the end of a word
     */
    public static List<String> choicesAfter(SourceFile beginning) {
        WorldParser parser = new WorldParser(beginning, Parameters.of(beginning, Map.of()));
        int last = beginning.lineCount();
        for (int line = 1; line < last; line++) {
            parser.read(line);
        }
        if (!Words.ofLine(beginning, last).isEmpty()) {
            return parser.read(last);
        }
        List<String> all = new ArrayList<>(parser.open == null ? List.of() : KindDraft.PARTS);
        all.addAll(STATEMENTS);
        return all;
    }

    /** The words of which one is missing at its end. */
    private List<String> read(int line) {
        try {
            if (Words.ofLine(file, line).take(Parameters.STATEMENT)) {
                open = null; // it is read already
                return List.of();
            }
            Words words = Words.ofLine(file, line, parameters);
            if (!words.isEmpty()) {
                read(words);
            }
            return List.of();
        } catch (Unreadable e) {
            findings.add(e.finding());
            return e.choices();
        }
    }

    private void read(Words words) throws Unreadable {
        if (KindDraft.PARTS.contains(words.first().text())) {
            part(words);
            return;
        }
        open = null;
        statement(words, words.choice("what there is", STATEMENTS).text());
        words.end();
    }

    private void part(Words words) throws Unreadable {
        if (open == null) {
            Word part = words.first();
            throw Words.broken(
                    part,
                    "'%s' is a part of robots: write it below a line 'kind NAME'"
                            .formatted(part.text()));
        }
        open.read(words);
    }

    private void statement(Words words, String what) throws Unreadable {
        switch (what) {
            case "floor" -> {
                single(words);
                width = words.number("its width in mm", 100, Words.FAR);
                depth = words.number("its depth in mm", 100, Words.FAR);
            }
            case "seconds" -> {
                single(words);
                seconds = words.count("how long it runs at most", 1, LONGEST);
            }
            case "goal" -> {
                single(words);
                goal = words.count("the cups to be delivered", 1, 1_000_000);
                words.expect("cups");
            }
            case "noise" -> {
                single(words);
                noise = noise(words);
            }
            case "line" -> line(words);
            case "wall" -> {
                List<Point> points = points(words, 2);
                stripes.add(
                        new Stripe(words.whole(), true, points, Bends.pieces(points, 0, false), 0));
            }
            case "kind" -> kind(words.name("the name of a kind"));
            case "robot" -> robots(RobotDraft.one(words));
            case "robots" -> robots(RobotDraft.several(words));
            case Parameters.STATEMENT ->
                    throw Words.broken(words.first(), "write 'parameter' as it is, without a '$'");
            case "thing" -> thing(words);
            default -> drinker(words);
        }
    }

    private void single(Words words) throws Unreadable {
        unique(words.first().text(), words.first());
    }

    /** What there is only once: a statement, or the bearer of a name. */
    private void unique(String name, Word word) throws Unreadable {
        Word before = once.putIfAbsent(name, word);
        if (before != null) {
            throw new Unreadable(
                    word.error(KindDraft.TWICE, "there are two '" + name + "'")
                            .withRelated(before.place(), "the first one"));
        }
    }

    private static Noise noise(Words words) throws Unreadable {
        if (words.take("none")) {
            return Noise.NONE;
        }
        Noise usual = Noise.USUAL;
        return new Noise(
                amount(words, "light", usual.light()),
                amount(words, "distance", usual.distance()),
                amount(words, "wheels", usual.wheels()),
                amount(words, "place", usual.place()),
                amount(words, "heading", usual.heading()));
    }

    private static double amount(Words words, String what, double usual) throws Unreadable {
        return words.take(what) ? words.number("a deviation", 0, 50) : usual;
    }

    private void line(Words words) throws Unreadable {
        boolean ring = words.take("ring");
        double wide = words.take("width") ? words.number("mm", 1, 1000) : LINE_WIDTH;
        double bend = words.take("bend") ? words.number("a radius in mm", 0, 10_000) : 0;
        List<Point> points = points(words, ring ? 3 : 2);
        stripes.add(
                new Stripe(words.whole(), false, points, Bends.pieces(points, bend, ring), wide));
    }

    private static List<Point> points(Words words, int least) throws Unreadable {
        List<Point> points = new ArrayList<>();
        while (words.hasNext() || points.size() < least) {
            points.add(words.point());
        }
        return points;
    }

    private void kind(Word name) throws Unreadable {
        open = new KindDraft(name);
        unique("kind " + name.text(), name);
        kinds.put(name.text(), open);
    }

    private void place(RobotDraft robot) throws Unreadable {
        unique(robot.name(), robot.place());
        robots.add(robot);
    }

    private void robots(RobotDraft.Row row) throws Unreadable {
        wanted.add(row.kind());
        for (RobotDraft robot : row.robots()) {
            place(robot);
        }
    }

    private void drinker(Words words) throws Unreadable {
        Word name = words.name("the name of a drinker");
        words.expect("at");
        Point spot = words.point();
        words.expect("every");
        double thirst = words.number("seconds from cup to cup", 0, LONGEST);
        unique(name.text(), name);
        drinkers.add(new Drinker(name.text(), spot, thirst, name.place()));
    }

    private void thing(Words words) throws Unreadable {
        Word name = words.name("the name of a thing");
        words.expect("at");
        Point spot = words.point();
        words.expect("body");
        double radius = KindDraft.radius(words);
        double mass = KindDraft.mass(words);
        double friction =
                words.take("friction") ? words.number("a share of its weight", 0, 2) : FRICTION;
        unique(name.text(), name);
        things.add(new Thing(name.text(), spot, radius, mass, friction, name.place()));
    }

    private Parsed result() {
        findings.addAll(parameters.findings());
        requireThere(once.containsKey("floor"), "a floor: write 'floor WIDTH DEPTH', in mm");
        requireThere(!robots.isEmpty(), "robots: write 'robot NAME KIND at X Y'");
        Map<String, Kind> built = new LinkedHashMap<>();
        for (KindDraft draft : kinds.values()) {
            draft.kind().ifPresent(kind -> built.put(kind.name(), kind));
            if (draft.kind().isEmpty() && findings.isEmpty()) {
                findings.add(
                        Words.broken(draft.name(), NO_PROGRAM.formatted(draft.name().text()))
                                .finding());
            }
        }
        List<Robot> placed = new ArrayList<>();
        for (RobotDraft robot : robots) {
            Kind kind = built.get(robot.kind().text());
            if (kind != null) {
                placed.add(robot.of(kind));
            }
        }
        wanted.stream()
                .filter(kind -> !kinds.containsKey(kind.text()))
                .forEach(kind -> findings.add(unknown(kind)));
        World world =
                new World(
                        width, depth, seconds, goal, noise, ways(), walls(), placed, drinkers,
                        things);
        if (findings.isEmpty()) {
            findings.addAll(Placement.check(world, stripes));
        }
        findings.sort(Diagnostic.ORDER);
        return new Parsed(
                findings.isEmpty() ? Optional.of(world) : Optional.empty(),
                built.values().stream().map(Kind::program).toList(),
                findings);
    }

    /** What is wrong already is told alone: it may be the reason. */
    private void requireThere(boolean there, String what) {
        if (!there && findings.isEmpty()) {
            Span beginning = file.span(0, 0);
            findings.add(Words.broken(beginning, "a world has " + what).finding());
        }
    }

    private static final String NO_PROGRAM =
            "kind '%s' has no program: write 'program component NAME in FOLDER' or 'program jar"
                    + " FILE' below it";

    private Diagnostic unknown(Word kind) {
        String known =
                kinds.isEmpty()
                        ? "none is described"
                        : "known: " + String.join(", ", kinds.keySet());
        return kind.error(UNKNOWN, "there is no kind '" + kind.text() + "' of robots; " + known);
    }

    private List<World.Line> ways() {
        return stripes.stream()
                .filter(stripe -> !stripe.isWall())
                .map(stripe -> new World.Line(stripe.pieces(), stripe.width()))
                .toList();
    }

    private List<Segment> walls() {
        return stripes.stream()
                .filter(Stripe::isWall)
                .flatMap(stripe -> stripe.pieces().stream())
                .toList();
    }
}
