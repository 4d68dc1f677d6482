package arcomat.pipeline.compile;

import static arcomat.semantics.ComponentBuilder.DISTANCE;
import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.MOTOR;
import static arcomat.semantics.ComponentBuilder.component;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.generate.SampleComponents;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.symbols.Scenario;
import arcomat.symbols.Workspace;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Large models compile, and run as small ones do. */
class LargeModelsTest {
    /** A ring of states, with a way back from each. */
    private static Component ring(int states) {
        String[] names = IntStream.range(0, states).mapToObj(i -> "s" + i).toArray(String[]::new);
        ComponentBuilder.AutomatonBuilder automaton =
                component("Ring")
                        .in(DISTANCE, "front")
                        .out(MOTOR, "cmd")
                        .automaton(Completion.IGNORE, names)
                        .initial("s0", "");
        for (int i = 0; i < states; i++) {
            automaton.on("s" + i + " -> s" + (i + 1) % states, "front = clear", "cmd = fwd");
            automaton.on("s" + i + " -> s0", "front = tooClose", "cmd = stop");
        }
        return automaton.build();
    }

    @Tag("slow")
    @Test
    void tenThousandStates() {
        Component ring = ring(10_000);
        CompiledModel model = CompiledModel.of(ring, Choosing.FIRST);
        CompiledExecution run = new CompiledExecution(model, List.of(), 0);
        Letter clear = Letter.of(Map.of("front", ComponentBuilder.value(DISTANCE, "clear")));
        for (int i = 0; i < 10_001; i++) {
            Trace.Activity activity = run.step(clear).activities().get(0);
            assertThat(activity.before()).isEqualTo("s" + i % 10_000);
            assertThat(activity.after()).isEqualTo("s" + (i + 1) % 10_000);
        }
    }

    @Tag("slow")
    @Test
    void aThousandStatesAgreeWithTheInterpreter() {
        new Agreement(ring(1000), List.of()).holds(5, 50);
    }

    /** A chain of parts that each add to a number within the slice, declared in the wrong order. */
    private static Component chain(int parts) {
        ComponentBuilder cell = component("Cell").in(INTEGER, "a").instantOut(INTEGER, "b");
        ComponentBuilder.AutomatonBuilder automaton =
                cell.automaton(Completion.IGNORE, "s").initial("s", "");
        Component add =
                automaton
                        .on(
                                "s",
                                "a = ?",
                                null,
                                List.of(
                                        automaton.send(
                                                "b",
                                                SampleComponents.binary(
                                                        arcomat.model.Expression.BinaryOperator
                                                                .PLUS,
                                                        cell.read("a"),
                                                        SampleComponents.number(1),
                                                        INTEGER))),
                                List.of())
                        .build();
        ComponentBuilder chain = component("Chain").in(INTEGER, "a").instantOut(INTEGER, "b");
        for (int i = parts - 1; i >= 0; i--) {
            chain.part("c" + i, add);
        }
        chain.connect("a", "c0.a");
        for (int i = 1; i < parts; i++) {
            chain.connect("c" + (i - 1) + ".b", "c" + i + ".a");
        }
        return chain.connect("c" + (parts - 1) + ".b", "b").build();
    }

    private static void sums(int parts) {
        CompiledModel model = CompiledModel.of(chain(parts), Choosing.FIRST);
        CompiledExecution run = new CompiledExecution(model, List.of(), 0);
        for (int i = 0; i < 3; i++) {
            Letter letter = Letter.of(Map.of("a", new Value.IntegerValue(i)));
            assertThat(run.step(letter).outputs().message("b"))
                    .contains(new Value.IntegerValue(i + parts));
        }
    }

    @Test
    void aThousandParts() {
        sums(1000);
    }

    /** Parts of one component, each fed by any other, a slice later. */
    private static Component tangle(int parts) {
        ComponentBuilder cell = component("Knot").in(INTEGER, "a").in(INTEGER, "c");
        ComponentBuilder.AutomatonBuilder automaton =
                cell.out(INTEGER, "b").automaton(Completion.IGNORE, "s", "t").initial("s", "");
        automaton.on(
                "s -> t", "a = ?", null, List.of(automaton.send("b", cell.read("a"))), List.of());
        automaton.on(
                "t -> s", "c = ?", null, List.of(automaton.send("b", cell.read("c"))), List.of());
        Component knot = automaton.build();
        ComponentBuilder tangle = component("Tangle").in(INTEGER, "a").out(INTEGER, "b");
        Random random = new Random(parts);
        for (int i = 0; i < parts; i++) {
            tangle.part("k" + i, knot);
        }
        for (int i = 0; i < parts; i++) {
            int sender = random.nextInt(parts);
            tangle.connect(i % 10 == 0 ? "a" : "k" + sender + ".b", "k" + i + ".a");
            tangle.connect("k" + random.nextInt(parts) + ".b", "k" + i + ".c");
        }
        return tangle.connect("k7.b", "b").build();
    }

    @Tag("slow")
    @Test
    void aTangleOfPartsAgreesWithTheInterpreter() {
        new Agreement(tangle(1200), List.of()).holds(3, 20);
    }

    @Test
    void severalHundredPartsAgreeWithTheInterpreter() {
        new Agreement(chain(250), List.of()).holds(3, 20);
    }

    @Test
    void aGuardOfTwoThousandTermsAgreesWithTheInterpreter() {
        String all = terms("a > -%d", " && ");
        String some = terms("b == %d", " || ");
        String model =
                """
                ==== Row.arc
                component Row {
                  timing instant;
                  port in Integer a, in Integer b, out Integer c;
                  <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s [%s] / {c = 1};
                    s [!(%s)] / {c = 2};
                  }
                }
                """;
        Workspace workspace = Scenario.of(model.formatted(all, some)).workspace();
        assertThat(Checks.run(workspace, Profile.EXECUTABLE)).isEmpty();
        Component row = Lowering.lower(workspace).components().get(0);
        new Agreement(row, List.of()).holds(3, 20);
    }

    /** Four times what one method can hold; the second guard is the negation of a row. */
    @Tag("slow")
    @Test
    void aGuardThatIsTooLongForAMethodAgreesWithTheInterpreter() {
        String model =
                """
                ==== Row.arc
                component Row {
                  timing instant;
                  port in Integer a, in Integer b, out Integer c;
                  <<completion = "ignore">> automaton {
                    state s, t;
                    initial s;
                    s [(%s) && b != 1 || a == 5] / {c = 1};
                    s -> t [!(%s)] / {c = 2};
                    t -> s [%s] / {c = 3};
                  }
                }
                """;
        String all = terms(10_000, "a > -%d", " && ");
        String some = terms(10_000, "b == 1%d", " || ");
        String both = terms(5_000, "(a == %1$d && b < %1$d)", " || ");
        Workspace workspace = Scenario.of(model.formatted(all, some, both)).workspace();
        assertThat(Checks.run(workspace, Profile.EXECUTABLE)).isEmpty();
        Component row = Lowering.lower(workspace).components().get(0);
        assertThat(new Agreement(row, List.of()).holds(3, 20).transitionsTaken()).hasSize(3);
    }

    private static String terms(String term, String operator) {
        return terms(2_000, term, operator);
    }

    private static String terms(int count, String term, String operator) {
        return IntStream.range(0, count)
                .mapToObj(i -> term.formatted(i))
                .collect(Collectors.joining(operator));
    }

    @Tag("slow")
    @Test
    void aHundredThousandParts() {
        sums(100_000);
    }
}
