package arcomat.editor.name;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Referent;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.IntPredicate;

/** Whatever has a name can be called otherwise, and then the same is found, and back again. */
class RenamingTest {
    /** What is added to a name: it stays one like those that models have. */
    private static final String ENDING = "Fresh";

    /** Why a thing may keep its name; anything else is a mistake of the renaming. */
    private static final String EXPECTED_REASONS =
            ".*(is a package|is built in|belongs to the library|which has syntax errors"
                    + "|'autoconnect').*";

    /** A fast test tries one of so many. */
    private static final int STRIDE = 10;

    private static final int FEWEST = 65;

    private static ShippedModels models;

    @BeforeAll
    static void read() {
        models = ShippedModels.checked();
    }

    @Tag("slow")
    @Test
    void someSymbolsAreRenamedThereAndBack() throws RenameRefused {
        assertThat(renameAll(number -> number % STRIDE == 0)).isGreaterThan(FEWEST);
    }

    /** Returns how many were renamed. */
    private static int renameAll(IntPredicate wanted) throws RenameRefused {
        int number = 0;
        int renamed = 0;
        for (OpenModels root : models.desk().models()) {
            for (Referent each : symbols(root)) {
                if (wanted.test(number++) && isRenamedThereAndBack(root, each)) {
                    renamed++;
                }
            }
        }
        return renamed;
    }

    /** All that files of the user's declare or name. */
    private static List<Referent> symbols(OpenModels root) {
        Map<Referent, Referent> symbols = new LinkedHashMap<>();
        root.paths().stream()
                .filter(path -> !root.isLibrary(path))
                .flatMap(path -> Mentions.in(root, path).stream())
                .map(Occurrence::referent)
                .forEach(each -> symbols.putIfAbsent(each, each));
        return new ArrayList<>(symbols.values());
    }

    private static boolean isRenamedThereAndBack(OpenModels before, Referent referent)
            throws RenameRefused {
        String where =
                referent.declaration().map(Object::toString).orElse("") + " " + referent.name();
        RenamePlan there;
        try {
            there = Renaming.plan(before, referent, referent.name() + ENDING, () -> {});
        } catch (RenameRefused refused) {
            assertThat(refused.getMessage()).as(where).matches(EXPECTED_REASONS);
            return false;
        }
        OpenModels after = there.applied(before).check(() -> {});
        assertThat(findings(after, new RenamePlan(Map.of(), Map.of(), Map.of(), Map.of())))
                .as(where)
                .isEqualTo(findings(before, there));
        if (there.written().isEmpty()) {
            RenamePlan back =
                    Renaming.plan(after, moved(after, there, referent), referent.name(), () -> {});
            assertThat(texts(back.applied(after))).as(where).isEqualTo(texts(before));
        }
        return true;
    }

    /** The same thing in the models after a renaming. */
    private static Referent moved(OpenModels after, RenamePlan plan, Referent referent) {
        var place = referent.declaration().orElseThrow();
        String path = plan.path(place.file().path());
        int start = plan.shift(place.file().path()).offset(place.start());
        Optional<Referent> found =
                after.paths().stream()
                        .flatMap(each -> Mentions.in(after, each).stream())
                        .map(Occurrence::referent)
                        .filter(each -> each.kind() == referent.kind())
                        .filter(
                                each ->
                                        each.declaration()
                                                .filter(
                                                        span ->
                                                                span.file().path().equals(path)
                                                                        && span.start() == start)
                                                .isPresent())
                        .findFirst();
        return found.orElseThrow();
    }

    /** Codes and places, as they are after what is planned. */
    private static TreeSet<String> findings(OpenModels models, RenamePlan plan) {
        TreeSet<String> found = new TreeSet<>();
        for (String path : models.checkedPaths()) {
            for (Diagnostic each : models.findings(path)) {
                found.add(
                        "%s:%d %s"
                                .formatted(
                                        plan.path(path),
                                        plan.shift(path).offset(each.span().start()),
                                        each.code()));
            }
        }
        return found;
    }

    private static Map<String, String> texts(OpenModels models) {
        Map<String, String> texts = new TreeMap<>();
        models.paths()
                .forEach(
                        path -> texts.put(path, models.source(path).map(s -> s.text()).orElse("")));
        return texts;
    }
}
