package arcomat.pipeline.campaign.joint;

import arcomat.pipeline.campaign.joint.JointRequirement.WatchedPort;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * What runs need where a campaign watches several robots for one requirement.
 *
 * @param classes class files of the monitors, by internal name
 * @param requirements in the order of the campaign
 * @param programs what is looked at in them, by what worlds say of them
 */
public record JointFreight(
        Map<String, byte[]> classes,
        List<JointRequirement> requirements,
        Map<String, ProgramTaps> programs) {
    /** Of a campaign that watches nothing of this kind. */
    public static final JointFreight NONE = new JointFreight(Map.of(), List.of(), Map.of());

    private static final String CLASSES = "joint/classes/";
    private static final String REQUIREMENTS = "joint/requirements";
    private static final String PROGRAMS = "joint/programs/";

    /** What is empty has to be a word, too. */
    private static final String EMPTY = "-";

    public JointFreight {
        classes = Map.copyOf(classes);
        requirements = List.copyOf(requirements);
        programs = Map.copyOf(programs);
    }

    /** Contents by name, none where there is nothing. */
    public Map<String, byte[]> entries() {
        Map<String, byte[]> entries = new TreeMap<>();
        classes.forEach((name, code) -> entries.put(CLASSES + name, code));
        programs.forEach(
                (key, taps) -> entries.put(PROGRAMS + hexadecimal(key), bytes(text(taps))));
        if (!requirements.isEmpty()) {
            StringBuilder text = new StringBuilder();
            requirements.forEach(each -> add(each, text));
            entries.put(REQUIREMENTS, bytes(text.toString()));
        }
        return entries;
    }

    private static void add(JointRequirement requirement, StringBuilder text) {
        text.append("watch " + requirement.column() + "\n");
        requirement.monitors().forEach(each -> text.append("monitor " + each + "\n"));
        requirement
                .arguments()
                .forEach(each -> text.append("argument " + word(hexadecimal(each)) + "\n"));
        for (WatchedPort each : requirement.ports()) {
            text.append(
                    "port %s %s %s %s %s\n"
                            .formatted(
                                    each.name(),
                                    each.field(),
                                    word(each.flag()),
                                    each.type(),
                                    each.total()));
        }
    }

    private static String text(ProgramTaps taps) {
        StringBuilder text = new StringBuilder("type " + taps.type() + "\n");
        for (PortTap each : taps.taps()) {
            text.append(
                    "tap %s %s %s %s %s %s\n"
                            .formatted(
                                    each.path(),
                                    word(each.fields()),
                                    each.message(),
                                    word(each.flag()),
                                    each.silentAtZero(),
                                    each.before()));
        }
        return text.toString();
    }

    /**
     * What entries hold, among others.
     *
     * @throws IOException where they are not what {@link #entries} gives
     */
    public static JointFreight of(Map<String, byte[]> entries) throws IOException {
        Map<String, byte[]> classes = new TreeMap<>();
        Map<String, ProgramTaps> programs = new TreeMap<>();
        for (Map.Entry<String, byte[]> each : entries.entrySet()) {
            String name = each.getKey();
            if (name.startsWith(CLASSES)) {
                classes.put(name.substring(CLASSES.length()), each.getValue());
            } else if (name.startsWith(PROGRAMS)) {
                programs.put(text(name.substring(PROGRAMS.length())), taps(each.getValue()));
            }
        }
        byte[] requirements = entries.getOrDefault(REQUIREMENTS, new byte[0]);
        return new JointFreight(classes, requirements(requirements), programs);
    }

    private static ProgramTaps taps(byte[] text) throws IOException {
        List<String> lines = lines(text);
        List<PortTap> taps = new ArrayList<>();
        for (String line : lines.subList(1, lines.size())) {
            List<String> words = words(line, 7);
            taps.add(
                    new PortTap(
                            words.get(1),
                            words.get(2),
                            words.get(3),
                            words.get(4),
                            Boolean.parseBoolean(words.get(5)),
                            Boolean.parseBoolean(words.get(6))));
        }
        return new ProgramTaps(words(lines.get(0), 2).get(1), taps);
    }

    private static List<JointRequirement> requirements(byte[] text) throws IOException {
        List<JointRequirement> all = new ArrayList<>();
        List<String> block = new ArrayList<>();
        for (String line : lines(text)) {
            if (line.startsWith("watch ") && !block.isEmpty()) {
                all.add(requirement(block));
                block.clear();
            }
            block.add(line);
        }
        if (!block.isEmpty()) {
            all.add(requirement(block));
        }
        return all;
    }

    private static JointRequirement requirement(List<String> block) throws IOException {
        List<String> monitors = new ArrayList<>();
        List<String> arguments = new ArrayList<>();
        List<WatchedPort> ports = new ArrayList<>();
        for (String line : block.subList(1, block.size())) {
            switch (line.substring(0, line.indexOf(' '))) {
                case "monitor" -> monitors.add(words(line, 2).get(1));
                case "argument" -> arguments.add(text(words(line, 2).get(1)));
                default -> ports.add(port(words(line, 6)));
            }
        }
        return new JointRequirement(words(block.get(0), 2).get(1), monitors, arguments, ports);
    }

    private static WatchedPort port(List<String> words) {
        return new WatchedPort(
                words.get(1),
                words.get(2),
                words.get(3),
                words.get(4),
                Boolean.parseBoolean(words.get(5)));
    }

    private static List<String> lines(byte[] text) {
        return new String(text, StandardCharsets.UTF_8).lines().toList();
    }

    private static List<String> words(String line, int count) throws IOException {
        List<String> words =
                Arrays.stream(line.split(" ", -1))
                        .map(each -> each.equals(EMPTY) ? "" : each)
                        .toList();
        if (words.size() != count) {
            throw new IOException("'" + line + "' has not " + count + " words");
        }
        return words;
    }

    private static String word(String text) {
        return text.isEmpty() ? EMPTY : text;
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** What worlds and models say may hold anything. */
    private static String hexadecimal(String text) {
        return HexFormat.of().formatHex(bytes(Objects.requireNonNull(text)));
    }

    private static String text(String hexadecimal) {
        return new String(HexFormat.of().parseHex(hexadecimal), StandardCharsets.UTF_8);
    }
}
