package arcomat.analysis.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.function.Predicate;

/** A component that has changed changes all that it is a part of. */
class ChangeImpactTest {
    private static Model model(String leaf) {
        String text =
                """
                ==== a/Leaf.arc
                package a;
                component Leaf {
                  port in Boolean x, out Boolean y;
                  automaton { state s; initial s; s {x == ?} / {y = %s}; }
                }
                ==== a/Other.arc
                package a;
                component Other { port in Boolean x; automaton { state s; initial s; s {x == ?}; } }
                ==== a/Mid.arc
                package a;
                component Mid { port in Boolean x; component Leaf leaf; connect x -> leaf.x; }
                ==== a/Top.arc
                package a;
                component Top {
                  port in Boolean x;
                  component Mid mid;
                  component Other other;
                  connect x -> mid.x, other.x;
                }
                """;
        return Lowering.lower(Scenario.of(text.formatted(leaf)).workspace());
    }

    private static List<String> names(Model model, Predicate<Component> which) {
        return model.components().stream().filter(which).map(Component::name).sorted().toList();
    }

    @Test
    void whatIsMadeOfItHasChangedToo() {
        Model fresh = model("false");
        ChangeImpact changed = ChangeImpact.between(model("true"), fresh);
        assertThat(names(fresh, changed::itself)).containsExactly("Leaf");
        assertThat(names(fresh, changed::contains)).containsExactly("Leaf", "Mid", "Top");
    }

    @Test
    void theSameTextHasNotChanged() {
        Model fresh = model("true");
        ChangeImpact changed = ChangeImpact.between(model("true"), fresh);
        assertThat(names(fresh, changed::contains)).isEmpty();
    }
}
