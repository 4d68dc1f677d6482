package arcomat.editor;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.refinement.Answered;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.AnalyzeAutomata;
import arcomat.pipeline.analysis.VerifyPromises;
import arcomat.pipeline.generate.GenerateCode;
import arcomat.pipeline.generate.RobotBuilder.BrickProgram;
import arcomat.pipeline.simulate.RunStreamTests;
import arcomat.report.brick.BrickReportText;
import arcomat.report.run.StreamTestText;
import arcomat.report.verdict.VerdictLine;
import arcomat.simulate.test.StreamTestResult;
import arcomat.source.Span;

import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/** What stands in the text is what the commands say about the same texts. */
class VerdictAgreementTest {
    private static final AnalysisLimits PATIENT =
            new AnalysisLimits(Optional.empty(), Optional.empty());

    /** By their types. */
    private static final List<List<String>> MESSAGES =
            List.of(
                    List.of("fwd", "stop", "backRight"),
                    List.of("tooClose", "clear"),
                    List.of("true", "false"));

    private static final int EDITS = 10;

    /** What can be done, beside what is said. */
    private static final Set<String> OFFERED = Set.of("run", "debug");

    @TempDir private Path temporary;

    @Tag("slow")
    @Test
    void inAllModels() throws IOException, WrongUse {
        Path folder = copied("coffee/coffee");
        try (EditorClient client = new EditorClient(folder.toRealPath())) {
            assertThat(inTheText(client, files(folder))).isEqualTo(byCommands(folder));
        }
    }

    /** Each edit makes another message of one, which may break a promise or a test. */
    @Tag("slow")
    @Test
    void afterEdits() throws IOException, WrongUse {
        Path folder =
                copied(
                        "coffee/coffee/fig3",
                        "coffee/coffee/fig5",
                        "coffee/coffee/fig6",
                        "coffee/coffee/types");
        Random random = new Random(15);
        Set<Map<String, List<String>>> answers = new HashSet<>();
        try (EditorClient client = new EditorClient(folder.toRealPath())) {
            List<String> files = files(folder);
            for (String file : files) {
                client.open(file);
            }
            List<String> written = files.stream().filter(file -> !file.endsWith(".cd")).toList();
            for (int i = 0; i < EDITS; i++) {
                String file = written.get(random.nextInt(written.size()));
                exchange(client, folder, file, random);
                Map<String, List<String>> commands = byCommands(folder);
                if (!commands.isEmpty()) {
                    answers.add(commands);
                    assertThat(inTheText(client, files)).as(file).isEqualTo(commands);
                }
            }
        }
        assertThat(answers).as("different answers").hasSizeGreaterThan(EDITS / 3);
    }

    private Path copied(String... parts) throws IOException {
        for (String part : parts) {
            Path from = Path.of("models").resolve(part);
            try (Stream<Path> all = Files.walk(from)) {
                for (Path file : all.filter(VerdictAgreementTest::isModel).toList()) {
                    Path to = temporary.resolve(Path.of("models/coffee").relativize(file));
                    Files.createDirectories(to.getParent());
                    Files.copy(file, to);
                }
            }
        }
        return temporary;
    }

    private static boolean isModel(Path file) {
        return Stream.of(".arc", ".cd", ".mt", ".ioautomaton", ".maa")
                .anyMatch(file.toString()::endsWith);
    }

    private static List<String> files(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(VerdictAgreementTest::isModel)
                    .map(file -> folder.relativize(file).toString().replace('\\', '/'))
                    .sorted()
                    .toList();
        }
    }

    /** On the screen, and on the disk for the commands. */
    private static void exchange(EditorClient client, Path folder, String file, Random random)
            throws IOException {
        String text = client.text(file).text();
        List<String> ofOneType = MESSAGES.get(random.nextInt(MESSAGES.size()));
        String from = ofOneType.get(random.nextInt(ofOneType.size()));
        String to = ofOneType.get(random.nextInt(ofOneType.size()));
        int at = text.indexOf(from, random.nextInt(text.length()));
        if (at < 0 || from.equals(to)) {
            exchange(client, folder, file, random);
            return;
        }
        Range range =
                new Range(position(client, file, at), position(client, file, at + from.length()));
        client.replace(file, range, to);
        Files.writeString(folder.resolve(file), client.text(file).text());
    }

    private static Position position(EditorClient client, String file, int offset) {
        var place = client.text(file).position(offset);
        return new Position(place.line() - 1, place.column() - 1);
    }

    private static Map<String, List<String>> inTheText(EditorClient client, List<String> files)
            throws IOException {
        Map<String, List<String>> found = new TreeMap<>();
        for (String file : files) {
            if (!client.isOpen(file)) {
                client.open(file);
            }
            for (CodeLens lens : new VerdictSteps(client).settled(file)) {
                String title = VerdictSteps.title(lens).replaceFirst(": show$", "");
                if (!OFFERED.contains(title)) {
                    found.computeIfAbsent(file, any -> new ArrayList<>()).add(title);
                }
            }
        }
        found.values().forEach(lines -> lines.sort(null));
        return found;
    }

    /** Nothing where the models have errors. */
    private static Map<String, List<String>> byCommands(Path folder) throws WrongUse {
        Session session = Session.in(folder, Progress.NONE);
        List<String> paths = List.of(".");
        Map<String, List<String>> found = new TreeMap<>();
        for (Answered each :
                session.run(new VerifyPromises(paths, PATIENT)).value().orElse(List.of())) {
            add(found, each.place(), VerdictLine.of(each));
        }
        for (StreamTestResult each :
                session.run(new RunStreamTests(paths)).value().orElse(List.of())) {
            add(found, each.test().span(), StreamTestText.line(each));
        }
        var automata = session.run(new AnalyzeAutomata(List.of(), paths, PATIENT)).value();
        Map<Span, List<Examination>> examined = new LinkedHashMap<>();
        automata.ifPresent(
                all ->
                        all.examinations()
                                .forEach(
                                        each ->
                                                examined.computeIfAbsent(
                                                                each.automaton().span(),
                                                                any -> new ArrayList<>())
                                                        .add(each)));
        examined.forEach((span, all) -> add(found, span, VerdictLine.of(all)));
        addPrograms(session, found);
        found.values().forEach(lines -> lines.sort(null));
        return found;
    }

    /** As many as there are to be deployed. */
    private static void addPrograms(Session session, Map<String, List<String>> found)
            throws WrongUse {
        var all =
                new GenerateCode("lejos", "made", Optional.empty(), false, List.of(), List.of("."));
        List<BrickProgram> programs =
                session.run(all).value().map(GenerateCode.Made::robots).orElse(List.of());
        for (BrickProgram each : programs) {
            String file = each.component().replace('.', '/') + ".arc";
            found.computeIfAbsent(file, any -> new ArrayList<>())
                    .add(BrickReportText.line(each.report()));
        }
    }

    private static void add(Map<String, List<String>> found, Span place, String line) {
        String file = place.file().path();
        found.computeIfAbsent(file, any -> new ArrayList<>()).add(line);
    }
}
