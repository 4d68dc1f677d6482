package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Generated files as they are, kept to be read and compared. After a change that is meant: {@code
 * ./gradlew test --tests '*GoldenTest' -PrefreshGolden}, then read what has changed.
 */
class GoldenTest {
    private static final Path FOLDER = Path.of("src/test/resources/golden");
    private static final Pattern DOC_COMMENT = Pattern.compile("(?s)/\\*\\*.*?\\*/");
    private static final Pattern MARKUP = Pattern.compile("<p>|\\{@code [^}]*\\}|&(amp|lt|gt);");

    @TestFactory
    List<DynamicTest> generatedFilesAreAsTheyWere() throws IOException {
        Model coffee = Lowering.lower(Scenario.models("models/coffee"));
        Component fetcher = coffee.component("coffee.fetcher.Fetcher").orElseThrow();
        Component fig3 = coffee.component("coffee.fig3.AvoidCrash").orElseThrow();
        List<DynamicTest> tests = new ArrayList<>();
        tests.addAll(compare("jvm/fetcher", Request.program(fetcher, Choosing.FIRST)));
        tests.addAll(compare("jvm/random", Request.library(fig3, Choosing.RANDOM).withTrace()));
        for (String folder :
                List.of(
                        "chain",
                        "composition",
                        "computed",
                        "events",
                        "expressions",
                        "guards",
                        "latched",
                        "mentions",
                        "names",
                        "newer-names",
                        "statements")) {
            Path file = Path.of("src/test/resources/agreement", folder + ".txt");
            Model model = Lowering.lower(Scenario.read(file).workspace());
            tests.addAll(compare("jvm/" + folder, Request.all(model, Choosing.FIRST)));
        }
        tests.addAll(onBrick("lejos/fetcher", fetcher));
        tests.addAll(monitor("monitor/fig6", coffee, "coffee.fig6.AvoidCrash"));
        tests.addAll(monitor("monitor/timer", coffee, "coffee.parts.Timer"));
        Path requirements = Path.of("src/test/resources/monitors/requirements.txt");
        Model doors = Lowering.lower(Scenario.read(requirements).workspace());
        tests.addAll(monitor("monitor/door", doors, "p.Door"));
        Path events = Path.of("src/test/resources/monitors/events.txt");
        Model bells = Lowering.lower(Scenario.read(events).workspace());
        tests.addAll(monitor("monitor/bell", bells, "p.Bell"));
        Path mentions = Path.of("src/test/resources/agreement/mentions.txt");
        Model counts = Lowering.lower(Scenario.read(mentions).workspace());
        tests.addAll(monitor("monitor/counts", counts, "p.Counts"));
        tests.addAll(monitor("monitor/ports", counts, "p.Ports"));
        return tests;
    }

    /** A project that has its documentation made has it made of generated code, too. */
    @Test
    void docCommentsAreHtml() throws IOException {
        for (String path : in("")) {
            DOC_COMMENT
                    .matcher(Files.readString(FOLDER.resolve(path)))
                    .results()
                    .map(comment -> MARKUP.matcher(comment.group()).replaceAll(""))
                    .forEach(text -> assertThat(text).as(path).doesNotContain("<", ">", "&"));
        }
    }

    private static List<DynamicTest> monitor(String folder, Model model, String name)
            throws IOException {
        Component watched = model.component(name).orElseThrow();
        Target target = Target.shipped("jvm").orElseThrow();
        return compare(folder, Monitors.generate(watched, watched.automata(), target));
    }

    /** The platform components come from the library's folder. */
    private static List<DynamicTest> onBrick(String folder, Component main) throws IOException {
        Path library = Path.of("lejos-runtime/nxt/src/main/java");
        Map<String, String> implementations = new TreeMap<>();
        try (Stream<Path> files = Files.walk(library)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String path = library.relativize(file).toString().replace('\\', '/');
                implementations.put(path, Files.readString(file));
            }
        }
        return compare(folder, Request.program(main, Choosing.FIRST).with(implementations));
    }

    private static List<DynamicTest> compare(String folder, Request request) throws IOException {
        String target = folder.substring(0, folder.indexOf('/'));
        return compare(folder, Generator.generate(request, Target.shipped(target).orElseThrow()));
    }

    private static List<DynamicTest> compare(String folder, Generation generation)
            throws IOException {
        assertThat(generation.findings()).isEmpty();
        TreeMap<String, String> files = new TreeMap<>();
        generation.files().forEach(f -> files.put(f.path(), f.text()));
        if (Boolean.getBoolean("golden.refresh")) {
            refresh(FOLDER.resolve(folder), files);
        }
        List<DynamicTest> tests = new ArrayList<>();
        files.forEach(
                (path, text) ->
                        tests.add(
                                DynamicTest.dynamicTest(
                                        folder + "/" + path,
                                        () -> {
                                            Path golden = FOLDER.resolve(folder).resolve(path);
                                            assertThat(text).isEqualTo(Files.readString(golden));
                                        })));
        tests.add(
                DynamicTest.dynamicTest(
                        folder + " has no other files",
                        () -> assertThat(files.keySet()).containsExactlyElementsOf(in(folder))));
        return tests;
    }

    private static List<String> in(String folder) throws IOException {
        Path root = FOLDER.resolve(folder);
        try (Stream<Path> files = Files.walk(root)) {
            return files.filter(Files::isRegularFile)
                    .map(f -> root.relativize(f).toString().replace('\\', '/'))
                    .sorted()
                    .toList();
        }
    }

    private static void refresh(Path folder, TreeMap<String, String> files) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> old = Files.walk(folder)) {
                for (Path file : old.sorted((a, b) -> b.compareTo(a)).toList()) {
                    Files.delete(file);
                }
            }
        }
        for (var file : files.entrySet()) {
            Path path = folder.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.writeString(path, file.getValue());
        }
    }
}
