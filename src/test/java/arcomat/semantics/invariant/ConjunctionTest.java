package arcomat.semantics.invariant;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.laws.draw.Draw;
import arcomat.laws.draw.InvariantText;
import arcomat.laws.draw.Plug;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Invariant;
import arcomat.model.Value;
import arcomat.models.ReadModels;
import arcomat.semantics.expression.Conjunction;
import arcomat.semantics.invariant.InvariantWatch.Truth;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.List;
import java.util.Set;

/**
 * What is judged in parts is true where the whole is, whichever messages there are: nothing is, or
 * all kinds are, missing, and numbers may be divided by zero.
 */
class ConjunctionTest {
    private static final int CONDITIONS = 250;

    private static final List<Plug> PORTS =
            List.of(plug("a", "Integer[0..2]"), plug("b", "Integer[0..2]"), plug("c", "Boolean"));

    private static final Value[] NUMBERS = {
        null, new Value.IntegerValue(0), new Value.IntegerValue(1), new Value.IntegerValue(2)
    };
    private static final Value[] TRUTHS = {
        null, new Value.BooleanValue(false), new Value.BooleanValue(true)
    };

    private static Plug plug(String name, String type) {
        return new Plug(name, true, type, false, 0, false);
    }

    @Tag("slow")
    @Test
    void theWholeIsTrueWhereAllPartsAre() {
        int several = 0;
        for (int seed = 0; seed < CONDITIONS; seed++) {
            String condition = InvariantText.of(new Draw(seed, Set.of()), PORTS, "");
            Component component = component(condition);
            Invariant whole = component.invariants().get(0);
            List<Expression> parts = Conjunction.parts(whole.condition());
            several += parts.size() > 1 ? 1 : 0;
            compare(component, whole, parts);
        }
        assertThat(several).isGreaterThan(CONDITIONS / 5);
    }

    private static Component component(String condition) {
        String text =
                """
                component Main {
                    port in Integer[0..2] a, in Integer[0..2] b, in Boolean c;
                    inv i: %s;
                    <<completion = "ignore">> automaton { state s; initial s; }
                }
                """
                        .formatted(condition);
        return ReadModels.model(new SourceFile("Main.arc", text)).component("Main").orElseThrow();
    }

    private static void compare(Component component, Invariant whole, List<Expression> parts) {
        for (Value a : NUMBERS) {
            for (Value b : NUMBERS) {
                for (Value c : TRUTHS) {
                    Value[] messages = {a, b, c};
                    boolean all =
                            parts.stream()
                                    .map(each -> new Invariant(whole.name(), each, whole.span()))
                                    .allMatch(each -> isTrue(component, each, messages));
                    assertThat(isTrue(component, whole, messages))
                            .as("%s with %s", whole.condition(), Arrays.asList(messages))
                            .isEqualTo(all);
                }
            }
        }
    }

    private static boolean isTrue(Component component, Invariant invariant, Value[] messages) {
        InvariantWatch watch = new InvariantWatch(component, invariant);
        List<String> names = List.of("a", "b", "c");
        Value[] seen =
                watch.seen().stream()
                        .map(each -> messages[names.indexOf(each.input().name())])
                        .toArray(Value[]::new);
        return watch.judge(List.of(), Arrays.asList(seen)) == Truth.TRUE;
    }
}
