package arcomat.analysis.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomPairs;
import arcomat.analysis.RandomPairs.Pair;
import arcomat.analysis.Replay;
import arcomat.analysis.Sections;
import arcomat.analysis.Verdicts;
import arcomat.analysis.evolution.Change.Relation;
import arcomat.analysis.refinement.Difference;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Value;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Versions compare as their promises do. Some are data: {@code
 * verify/src/test/resources/analysis/succession.txt} has files of two models, below {@code old} and
 * {@code new}. Below {@code == change C}, perhaps with numbers to instantiate C with, stands what
 * became of C, and then what shows it.
 */
class VersionComparisonTest {
    private static final Path DATA = Path.of("verify/src/test/resources/analysis/succession.txt");
    private static final Map<Difference.Relation, Relation> SAME =
            Map.of(
                    Difference.Relation.EQUIVALENT, Relation.EQUIVALENT,
                    Difference.Relation.REFINES, Relation.REFINES,
                    Difference.Relation.IS_REFINED_BY, Relation.WIDENS,
                    Difference.Relation.INCOMPARABLE, Relation.INCOMPARABLE);

    @Test
    void agreesWithDifferencesOfRandomPairs() {
        Map<Relation, Integer> seen = new EnumMap<>(Relation.class);
        for (Pair pair : RandomPairs.any(3, 200)) {
            Promise left = pair.left();
            Promise right = pair.right();
            Change change =
                    new VersionComparison(
                                    right.component(),
                                    " (base)",
                                    left.component(),
                                    Budget::ofMemory)
                            .with(Set.of());
            Difference difference = Difference.of(left, right, Budget.ofMemory());
            assertThat(change.relation()).isEqualTo(SAME.get(difference.relation()));
            seen.merge(change.relation(), 1, Integer::sum);
            if (change.relation().breaks()) {
                Verdict shown = change.witnesses().get(0).verdict();
                assertThat(shown.explanation()).isNotEmpty();
                Replay.check(left, right, shown);
            }
        }
        assertThat(seen.keySet()).containsAll(SAME.values());
    }

    @Test
    void whatSaysTheSameIsEquivalent() {
        for (Pair pair : RandomPairs.any(4, 50)) {
            assertThat(SameMeaning.own(pair.left().component(), pair.left().component())).isTrue();
            boolean same =
                    SameMeaning.own(
                            namesake(pair.left().component()), namesake(pair.right().component()));
            Difference difference = Difference.of(pair.left(), pair.right(), Budget.ofMemory());
            assertThat(!same || difference.relation() == Difference.Relation.EQUIVALENT).isTrue();
        }
        assertThat(List.of(Relation.GONE, Relation.WIDENS, Relation.INCOMPARABLE))
                .allMatch(Relation::breaks);
    }

    @TestFactory
    Stream<DynamicTest> changes() {
        Sections sections = Sections.read(DATA);
        Model old = model(sections, "old/");
        Model fresh = model(sections, "new/");
        return sections.of("change").stream()
                .map(
                        each ->
                                DynamicTest.dynamicTest(
                                        each.rest(),
                                        () ->
                                                assertThat(change(old, fresh, each.rest()))
                                                        .isEqualTo(each.lines())));
    }

    private static Model model(Sections sections, String folder) {
        return ReadModels.model(
                sections.sources().stream()
                        .filter(file -> file.path().startsWith(folder))
                        .map(file -> new SourceFile(file.path().substring(4), file.text()))
                        .toList());
    }

    private static List<String> change(Model old, Model fresh, String asked) {
        String[] words = asked.split(" ");
        Set<List<Value>> given = new LinkedHashSet<>();
        for (int i = 1; i < words.length; i++) {
            given.add(List.of(new Value.IntegerValue(Long.parseLong(words[i]))));
        }
        Change change =
                new VersionComparison(
                                old.component(words[0]).orElseThrow(),
                                " (base)",
                                fresh.component(words[0]).orElseThrow(),
                                Budget::ofMemory)
                        .with(given);
        List<String> lines = new ArrayList<>();
        lines.add(
                (change.relation().name().toLowerCase(Locale.ROOT) + " " + change.reason())
                        .strip());
        for (Change.Witness each : change.witnesses()) {
            String sides = each.left() + ", " + each.right() + ": ";
            boolean unknown = each.verdict().answer() == Verdict.Answer.UNKNOWN;
            lines.add(
                    sides
                            + (unknown
                                    ? each.verdict().reason()
                                    : Verdicts.text(each.verdict(), "fails says ")));
        }
        return lines;
    }

    /** The same component under a name that all have in common. */
    private static Component namesake(Component component) {
        return new Component(
                component.packageName(),
                "X",
                component.layer(),
                component.platform(),
                component.deploy(),
                component.profile(),
                component.queueCapacity(),
                component.cycle(),
                component.parameters(),
                component.constants(),
                component.ports(),
                component.body(),
                component.requirements(),
                component.refines(),
                List.of(),
                component.span());
    }
}
