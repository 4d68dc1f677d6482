package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.LawBook;
import arcomat.check.law.Law;
import arcomat.check.law.Profile;
import arcomat.pipeline.check.Explanations;
import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.syntax.Parser;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The index of findings is made of the pages that explain them. {@code -Dtranscripts.update=true}
 * writes it anew.
 */
class ErrorIndexTest {
    private static final Path INDEX = Path.of("docs/errors.md");
    private static final String PAGES = "src/main/resources/explain/";
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");
    private static final Pattern SEEN = Pattern.compile("\\b(error|warning) (ARC\\d{4})\\b");

    /** Findings that are not of checks are errors, but for these. */
    private static final Set<String> WARNINGS =
            Set.of(
                    "ARC0008", "ARC0405", "ARC0406", "ARC0712", "ARC0713", "ARC0912", "ARC0914",
                    "ARC0915", "ARC1001", "ARC1003", "ARC1004", "ARC1005", "ARC1006", "ARC1009",
                    "ARC1010", "ARC1103", "ARC1104");

    private static final Map<String, String> SPECIAL =
            Map.of(
                    "ARC0007", "error; warning for folders",
                    "ARC0916", "error; warning of `check-brick`",
                    "ARC0917", "error; warning from 80 %",
                    "ARC0918", "error; warning from 80 %",
                    "ARC1002", "warning; error where completion is `error`",
                    "ARC1105", "error; warning where it is not decided");

    private static final Map<String, String> CHAPTERS = new LinkedHashMap<>();

    static {
        CHAPTERS.put("00", "Files and syntax");
        CHAPTERS.put("01", "Structure");
        CHAPTERS.put("02", "Names");
        CHAPTERS.put("03", "Automata, expressions and tables");
        CHAPTERS.put("04", "Refinement");
        CHAPTERS.put("05", "Stereotypes and layers");
        CHAPTERS.put("06", "Class diagrams");
        CHAPTERS.put("07", "Stream tests");
        CHAPTERS.put("08", "Generating and running");
        CHAPTERS.put("09", "The brick");
        CHAPTERS.put("10", "Analyses");
        CHAPTERS.put("11", "The gate");
        CHAPTERS.put("12", "Guests");
    }

    private static final String BEGINNING =
            """
            # Findings

            Everything that the tool can find in a model, a test, a target or a jar, by its code. A code leads to a page that says
            why the law exists, with a wrong model and a right one; `arcomat explain CODE` shows the same page. *For code* means:
            with `--profile executable`, and when code is generated. Which findings can be meant, and how to say so, is in
            [CI](ci.md#findings-that-are-meant).
            """;

    @Test
    void isWhatThePagesSay() throws IOException {
        if (UPDATE) {
            Files.writeString(INDEX, index());
        }
        assertThat(INDEX).hasContent(index());
    }

    /** What tests have seen of a finding agrees with what the index says. */
    @ParameterizedTest
    @ValueSource(strings = {"src/test/resources", "docs"})
    void severitiesAreThoseSeen(String folder) throws IOException {
        for (Map.Entry<String, Set<String>> seen : seen(Path.of(folder)).entrySet()) {
            assertThat(severity(seen.getKey())).as(seen.getKey()).contains(seen.getValue());
        }
    }

    /** Models of checks are tried with the checks; those on other pages follow the grammar. */
    @Test
    void modelsOnThePagesFollowTheGrammar() throws IOException {
        Set<String> checks = new TreeSet<>();
        LawBook.OWN.own().forEach(law -> checks.add(law.code()));
        for (String code : Explanations.titles().keySet()) {
            boolean aboutFiles = code.startsWith("ARC00");
            for (Fence fence : Fence.of(Path.of(PAGES + code + ".md"))) {
                if (!aboutFiles && !checks.contains(code) && fence.isModel()) {
                    SourceFile model = new SourceFile(code + "." + fence.language(), fence.text());
                    assertThat(Parser.parse(model).findings()).as(code).isEmpty();
                }
            }
        }
    }

    private static String index() {
        StringBuilder page = new StringBuilder(BEGINNING);
        Map<String, String> titles = new TreeMap<>(Explanations.titles());
        CHAPTERS.forEach(
                (range, chapter) -> {
                    page.append("\n## %s\n\n| code | | |\n|---|---|---|\n".formatted(chapter));
                    titles.keySet().stream()
                            .filter(code -> code.startsWith("ARC" + range))
                            .forEach(code -> page.append(row(code, titles.get(code))));
                });
        assertThat(titles.keySet()).allMatch(code -> CHAPTERS.containsKey(code.substring(3, 5)));
        return page.toString();
    }

    private static String row(String code, String title) {
        return "| [%s](../%s%s.md) | %s | %s |\n"
                .formatted(code, PAGES, code, title, severity(code));
    }

    private static String severity(String code) {
        Optional<Law> law =
                LawBook.OWN.own().stream().filter(l -> l.code().equals(code)).findFirst();
        return law.map(ErrorIndexTest::severity)
                .orElseGet(
                        () ->
                                SPECIAL.getOrDefault(
                                        code, WARNINGS.contains(code) ? "warning" : "error"));
    }

    private static String severity(Law law) {
        Optional<Severity> early = law.severity(Profile.REQUIREMENTS);
        String late = word(law.inExecutable());
        if (early.isEmpty()) {
            return late + " for code";
        }
        String word = word(early.get());
        return word.equals(late) ? word : word + "; " + late + " for code";
    }

    private static String word(Severity severity) {
        return severity == Severity.ERROR ? "error" : "warning";
    }

    private static Map<String, Set<String>> seen(Path folder) throws IOException {
        Map<String, Set<String>> seen = new TreeMap<>();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
                Matcher finding = SEEN.matcher(text);
                while (finding.find()) {
                    seen.computeIfAbsent(finding.group(2), code -> new TreeSet<>())
                            .add(finding.group(1));
                }
            }
        }
        return seen;
    }
}
