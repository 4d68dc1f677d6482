package arcomat.fuzz.process;

import arcomat.fuzz.ModelSet;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The undamaged files: the project's own, and what the tool makes of them. */
final class Seeds {
    static final Path COFFEE = Path.of("models/coffee");
    private static final Path DATA = Path.of("src/test/resources");
    private static final Pattern PACKAGE = Pattern.compile("(?m)^package ([\\w.]+);");

    /** A file of data may hold several models, each below a line with its path. */
    private static final Pattern PART = Pattern.compile("(?ms)^//// (\\S+)\n(.*?)(?=^//// |\\z)");

    private static final Pattern COMPONENT = Pattern.compile("(?m)^[^/*]*component (\\w+)");
    private static final Set<Integer> MADE = Set.of(0, 1);
    private static final List<String> PAIRS =
            List.of(
                    "coffee.fig5.AvoidCrash coffee.fig3.AvoidCrash",
                    "coffee.fig6.AvoidCrash coffee.fig5.AvoidCrash",
                    "coffee.fig6.AvoidCrash coffee.fig3.AvoidCrash");

    /** The models of the case study below {@code m/}, with nothing else of it. */
    private final SortedMap<String, byte[]> coffee;

    private final List<SortedMap<String, byte[]>> small;
    private final List<SortedMap<String, byte[]>> sound;
    private final SortedMap<String, byte[]> bad;
    private final SortedMap<String, byte[]> made;

    /**
     * @param tool makes robots, certificates and such of the models
     * @param sandbox where it may do so
     */
    Seeds(Tool tool, Sandbox sandbox) throws IOException, InterruptedException {
        coffee = read(COFFEE, "m/", ".*\\.(arc|cd|mt|ioautomaton)");
        small = new ArrayList<>(pages());
        sound = new ArrayList<>(small);
        for (Path file : modelsIn(DATA)) {
            small.add(single(file, "m/"));
            if (!file.toString().matches(".*/(check|symbols|syntax)/.*")) {
                sound.add(single(file, "m/"));
            }
        }
        bad = single(DATA.resolve("check/PortConnectedToItself.arc"), "b/");
        bad.putAll(single(DATA.resolve("check/SuppressionUsed.arc"), "b/"));
        made = make(tool, sandbox);
    }

    /** All models of the case study, by path. */
    SortedMap<String, byte[]> coffee() {
        return new TreeMap<>(coffee);
    }

    /**
     * Those of the figures, which are enough for a proof, and below {@code b/} two with findings.
     */
    SortedMap<String, byte[]> figures() {
        SortedMap<String, byte[]> figures = coffee();
        figures.keySet().removeIf(path -> !path.matches("m/coffee/(fig\\d|types)/.*"));
        figures.putAll(bad);
        return figures;
    }

    /** Small sets of models, of the tests and of the pages. */
    List<SortedMap<String, byte[]>> small() {
        return small;
    }

    /** Those of them that are not there for what is wrong with them. */
    List<SortedMap<String, byte[]>> sound() {
        return sound;
    }

    /**
     * What the tool has made: jars below {@code brick/}, {@code state}, {@code 1.certificate} ..
     */
    SortedMap<String, byte[]> made() {
        return made;
    }

    List<String> pairs() {
        return PAIRS;
    }

    static SortedMap<String, byte[]> read(Path folder, String prefix, String names)
            throws IOException {
        SortedMap<String, byte[]> files = new TreeMap<>();
        try (Stream<Path> paths = Files.walk(folder)) {
            for (Path path : (Iterable<Path>) paths::iterator) {
                String name = folder.relativize(path).toString();
                if (Files.isRegularFile(path) && name.matches(names) && !name.startsWith("build")) {
                    files.put(prefix + name, Files.readAllBytes(path));
                }
            }
        }
        return files;
    }

    /** The names of components that are defined in files, by the packages of these. */
    static List<String> components(Map<String, byte[]> models) {
        List<String> names = new ArrayList<>();
        for (byte[] content : models.values()) {
            String text = new String(content, java.nio.charset.StandardCharsets.UTF_8);
            Matcher component = COMPONENT.matcher(text);
            if (component.find()) {
                Matcher package_ = PACKAGE.matcher(text);
                String prefix = package_.find() ? package_.group(1) + "." : "";
                names.add(prefix + component.group(1));
            }
        }
        return names;
    }

    private static List<SortedMap<String, byte[]>> pages() {
        List<SortedMap<String, byte[]>> sets = new ArrayList<>();
        for (String page : List.of("language", "tutorial", "semantics", "ci", "gate")) {
            SortedMap<String, byte[]> files = new TreeMap<>();
            ModelSet.page(page, Path.of("docs", page + ".md"))
                    .files()
                    .forEach((path, file) -> files.put("m/" + path, bytes(file.file().text())));
            if (!files.isEmpty()) {
                sets.add(files);
            }
        }
        return sets;
    }

    private static List<Path> modelsIn(Path folder) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            return paths.filter(path -> path.toString().matches(".*\\.(arc|cd|mt|ioautomaton)"))
                    .sorted()
                    .toList();
        }
    }

    /** The models of one file of data: each at the place that its package asks for. */
    private static SortedMap<String, byte[]> single(Path file, String root) throws IOException {
        String text = Files.readString(file);
        SortedMap<String, byte[]> models = new TreeMap<>();
        Matcher part = PART.matcher(text);
        while (part.find()) {
            models.put(root + part.group(1), bytes(part.group(2)));
        }
        if (models.isEmpty()) {
            Matcher package_ = PACKAGE.matcher(text);
            String folder = package_.find() ? package_.group(1).replace('.', '/') + "/" : "";
            models.put(root + folder + file.getFileName(), bytes(text));
        }
        return models;
    }

    private SortedMap<String, byte[]> make(Tool tool, Sandbox sandbox)
            throws IOException, InterruptedException {
        sandbox.fill(coffee);
        run(tool, sandbox, "generate", "--target", "lejos", "--out", "brick", "m");
        SortedMap<String, byte[]> all = sandbox.content();
        sandbox.fill(figures());
        run(tool, sandbox, "check", "--state", "state", "m", "b");
        run(tool, sandbox, "check", "--write-baseline", "baseline", "m", "b");
        for (int i = 0; i < PAIRS.size(); i++) {
            String[] pair = PAIRS.get(i).split(" ");
            run(tool, sandbox, "refines", "--certificate", i + ".proof", pair[0], pair[1], "m");
        }
        all.putAll(sandbox.content());
        all.keySet().removeIf(path -> path.startsWith("m/") || path.endsWith(".java"));
        return all;
    }

    private static void run(Tool tool, Sandbox sandbox, String... arguments)
            throws IOException, InterruptedException {
        Outcome outcome = tool.run(sandbox, Call.of(MADE, arguments));
        if (outcome.status().filter(MADE::contains).isEmpty()) {
            throw new IllegalStateException(String.join(" ", arguments) + "\n" + outcome.said());
        }
    }

    private static byte[] bytes(String text) {
        return text.getBytes(java.nio.charset.StandardCharsets.UTF_8);
    }
}
