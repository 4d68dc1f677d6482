package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * ARC0810: generated classes that no Java virtual machine can hold. Code is laid out so that there
 * are few; which ones is for a compiler to tell, which is asked about large files only.
 */
public final class OversizedCode {
    private static final String TOO_LARGE = "ARC0810";
    private static final String JAVA = ".java";

    /** A method of 64 kB and a text of as many bytes need more than that. */
    private static final int SMALL_FILE = 20_000;

    /** So do 256 parameters, which stand on one line. */
    private static final int SHORT_LINE = 1_000;

    private static final int LONGEST_TEXT = 65_535;

    private final CodeLayout layout;

    private OversizedCode(CodeLayout layout) {
        this.layout = layout;
    }

    /** What is too large; files in Java are looked at. */
    public static List<Diagnostic> in(Generation generation) {
        Map<String, String> large = new LinkedHashMap<>();
        Map<String, String> others = new LinkedHashMap<>();
        for (GeneratedFile file : generation.files()) {
            if (file.path().endsWith(JAVA)) {
                (isLarge(file.text()) ? large : others).put(file.path(), file.text());
            }
        }
        if (large.isEmpty()) {
            return List.of();
        }
        Compilation compilation = MemoryCompiler.compile(large, others, ClassFiles.RUNTIME);
        OversizedCode code = new OversizedCode(generation.layout());
        Stream<Compilation.Problem> texts =
                large.entrySet().stream()
                        .filter(each -> StringConstants.longest(each.getValue()) > LONGEST_TEXT)
                        .map(each -> longText(each.getKey()));
        return Stream.concat(compilation.problems().stream(), texts)
                .flatMap(each -> code.finding(each).stream())
                .distinct()
                .sorted(Diagnostic.ORDER)
                .toList();
    }

    /** The JDK's compiler refuses what the one in here cuts into pieces. */
    private static Compilation.Problem longText(String path) {
        return new Compilation.Problem(path, 1, 0, 0, "", Optional.of(JavaLimit.TEXT));
    }

    private static boolean isLarge(String text) {
        return text.length() > SMALL_FILE
                || text.lines().anyMatch(line -> line.length() > SHORT_LINE);
    }

    /** What is said of a class; empty where a problem is another one. */
    public static Optional<Diagnostic> finding(Compilation.Problem problem, CodeLayout layout) {
        return new OversizedCode(layout).finding(problem);
    }

    private Optional<Diagnostic> finding(Compilation.Problem problem) {
        Optional<Map.Entry<String, CodeLayout.Place>> component = component(problem.path());
        return problem.limit()
                .map(
                        limit ->
                                Diagnostic.error(
                                        TOO_LARGE,
                                        component
                                                .map(each -> each.getValue().span())
                                                .orElseGet(() -> nowhere(problem.path())),
                                        "the code of '"
                                                + component
                                                        .map(Map.Entry::getKey)
                                                        .orElse(problem.path())
                                                + "' is too large for Java: it would have "
                                                + limit.words()
                                                + "; make several of it"));
    }

    private static Span nowhere(String path) {
        return new SourceFile(path, "").span(0, 0);
    }

    /** The component that a class belongs to; a large one has several, whose names begin alike. */
    private Optional<Map.Entry<String, CodeLayout.Place>> component(String path) {
        String name = path.substring(0, path.length() - JAVA.length()).replace('/', '.');
        return layout.components().entrySet().stream()
                .filter(each -> name.startsWith(each.getValue().className()))
                .max(Comparator.comparingInt(each -> each.getValue().className().length()));
    }
}
