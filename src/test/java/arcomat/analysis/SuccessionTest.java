package arcomat.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Change.Relation;
import arcomat.analysis.RandomPairs.Pair;
import arcomat.model.Component;

import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Versions compare as their promises do. */
class SuccessionTest {
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
                    Succession.of(
                            right.component(),
                            " (base)",
                            left.component(),
                            Set.of(),
                            Budget::ofMemory);
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
                component.span());
    }
}
