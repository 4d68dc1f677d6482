package arcomat.pipeline.campaign.measure;

import arcomat.campaign.Campaign;
import arcomat.campaign.Variation;
import arcomat.campaign.Variation.Choice;
import arcomat.source.SourceFile;
import arcomat.syntax.Parser;
import arcomat.world.World;
import arcomat.world.WorldParser;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What can be read in the worlds of a campaign, as models would declare it: each robot, each
 * drinker and each thing is an object on an input of its own. A campaign may add robots, so this is
 * what there is with the values that parameters have by themselves, and with the ends of all ranges
 * and all words, one after the other.
 */
public final class Vocabulary {
    static final String PACKAGE = "campaign";

    /** Longer than the name of any brick, as all types are named like what has them. */
    private static final String CUP_TYPE = "ContentsOfAHolder";

    /** By the names of robots, drinkers and things: types by properties. */
    private final Map<String, Map<String, String>> objects = new TreeMap<>();

    private Vocabulary() {}

    /**
     * @param world text of the world, with its parameters
     */
    public static Vocabulary of(Campaign campaign, SourceFile world) {
        Vocabulary vocabulary = new Vocabulary();
        Stream<Map<String, String>> others =
                campaign.variations().stream()
                        .flatMap(
                                each ->
                                        values(each).stream()
                                                .map(value -> Map.of(each.parameter(), value)));
        Stream.concat(Stream.of(Map.<String, String>of()), others)
                .flatMap(values -> WorldParser.parse(world, values).world().stream())
                .forEach(vocabulary::add);
        vocabulary.objects.keySet().removeIf(name -> !canBeWritten(name));
        return vocabulary;
    }

    private static List<String> values(Variation variation) {
        return variation.domain().match(range -> List.of(range.at(0), range.at(1)), Choice::words);
    }

    /** All that can be read, as it is written: {@code one.x}. */
    public List<String> readings() {
        return objects.entrySet().stream()
                .flatMap(
                        object ->
                                object.getValue().keySet().stream()
                                        .map(property -> object.getKey() + "." + property))
                .toList();
    }

    private void add(World world) {
        for (World.Robot robot : world.robots()) {
            Map<String, String> properties = properties(robot.name());
            Arrays.stream(RobotProperty.values())
                    .forEach(each -> properties.put(each.word(), each.type()));
            properties.put(Gauge.DISPLAY, "String");
            properties.put(Gauge.CUP, CUP_TYPE);
            robot.kind()
                    .sensors()
                    .forEach(each -> properties.put(Gauge.SOCKET + each.socket(), "Integer"));
        }
        for (World.Drinker drinker : world.drinkers()) {
            Map<String, String> properties = properties(drinker.name());
            properties.put(Gauge.PRESENT, "Boolean");
            properties.put(Gauge.CUPS, "Integer");
        }
        for (World.Thing thing : world.things()) {
            Map<String, String> properties = properties(thing.name());
            properties.put(Gauge.X, "Double");
            properties.put(Gauge.Y, "Double");
        }
    }

    private Map<String, String> properties(String object) {
        return objects.computeIfAbsent(object, name -> new TreeMap<>());
    }

    /** Names of bricks may have a - in them, or be words of the language. */
    private static boolean canBeWritten(String name) {
        String text = "component Any { port in Integer %s; }".formatted(name);
        return Parser.parse(new SourceFile("Any.arc", text)).unit().isPresent();
    }

    /** The types, as the text of a class diagram. */
    SourceFile diagram() {
        StringBuilder text =
                new StringBuilder("package " + PACKAGE + ";\nclassdiagram Readings {\n");
        String cups =
                Arrays.stream(World.Cup.values()).map(Enum::name).collect(Collectors.joining(", "));
        text.append("enum %s { %s; }\n".formatted(CUP_TYPE, cups));
        objects.forEach(
                (name, properties) -> {
                    text.append("class %s {\n".formatted(name));
                    properties.forEach(
                            (property, type) -> text.append(type + " " + property + ";\n"));
                    text.append("}\n");
                });
        return new SourceFile("campaign/Readings.cd", text.append("}\n").toString());
    }

    /** The inputs, each with a comma behind it. */
    String ports() {
        StringBuilder ports = new StringBuilder();
        Map<String, String> all = new TreeMap<>();
        all.put(Gauge.TIME, "Double");
        all.put(Gauge.DELIVERED, "Integer");
        objects.keySet().forEach(name -> all.put(name, name));
        all.forEach((name, type) -> ports.append("in %s %s, ".formatted(type, name)));
        return ports.toString();
    }
}
