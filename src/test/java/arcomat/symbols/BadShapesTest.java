package arcomat.symbols;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.Delays.DelayCycle;
import arcomat.symbols.names.ClassSymbol;
import arcomat.translate.HouseLanguages;

import org.junit.jupiter.api.Test;

import java.util.Set;

/** Shapes that only a machine or a malicious person writes: nothing loops, nothing overflows. */
class BadShapesTest {
    private static final int DEPTH = 5_000;

    @Test
    void aLongChainOfSuperComponents() {
        StringBuilder text =
                new StringBuilder("==== p/C0.arc\npackage p; component C0 { port in int a; }\n");
        for (int i = 1; i < DEPTH; i++) {
            text.append("==== p/C").append(i).append(".arc\npackage p; component C").append(i);
            text.append(" extends C").append(i - 1).append(" { }\n");
        }
        Workspace workspace = Scenario.of(text.toString()).workspace();
        ComponentSymbol last = workspace.components("p.C" + (DEPTH - 1)).get(0);
        assertThat(last.port("a")).isPresent();
        assertThat(last.lineage()).hasSize(DEPTH);
    }

    @Test
    void aDeepNestOfCompositions() {
        StringBuilder text = new StringBuilder();
        text.append("==== p/C0.arc\npackage p; component C0 { timing instant; ");
        text.append("port in int a, out int b; }\n");
        for (int i = 1; i < DEPTH; i++) {
            text.append("==== p/C").append(i).append(".arc\npackage p; component C").append(i);
            text.append(" { port in int a, out int b; component C").append(i - 1);
            text.append(" c [b -> b]; connect a -> c.a; }\n");
        }
        text.append("==== p/Top.arc\npackage p; component Top { component C");
        text.append(DEPTH - 1).append(" c [b -> c.a]; }\n");
        Workspace workspace = Scenario.of(text.toString()).workspace();
        ComponentSymbol top = workspace.components("p.Top").get(0);
        assertThat(workspace.delays().cycles(top))
                .extracting(DelayCycle::text)
                .containsExactly("c -> c");
        ComponentSymbol below = workspace.components("p.C" + (DEPTH - 1)).get(0);
        assertThat(workspace.delays().effective(below, below.port("b").orElseThrow())).isZero();
        assertThat(workspace.subcomponentCycles()).isEmpty();
    }

    @Test
    void aLongCycleOfSubcomponents() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < DEPTH; i++) {
            text.append("==== p/C").append(i).append(".arc\npackage p; component C").append(i);
            text.append(" { component C").append((i + 1) % DEPTH).append(" c; }\n");
        }
        Workspace workspace = Scenario.of(text.toString()).workspace();
        assertThat(workspace.subcomponentCycles()).hasSize(1);
        assertThat(workspace.subcomponentCycles().get(0)).hasSize(DEPTH);
        assertThat(workspace.delays().cycles(workspace.components().get(0))).isEmpty();
    }

    @Test
    void classesThatExtendEachOther() {
        Workspace workspace =
                Scenario.of(
                                """
                                ==== p/T.cd
                                package p;
                                classdiagram T {
                                  class A extends B { int a; }
                                  class B extends A { int b; }
                                  class C extends A { int c; }
                                }
                                """)
                        .workspace();
        assertThat(workspace.types("p.T.A").get(0))
                .isInstanceOfSatisfying(
                        ClassSymbol.class, a -> assertThat(a.isItsOwnAncestor()).isTrue());
        assertThat(workspace.types("p.T.C").get(0))
                .isInstanceOfSatisfying(
                        ClassSymbol.class,
                        c -> {
                            assertThat(c.isItsOwnAncestor()).isFalse();
                            assertThat(c.attribute("b")).isPresent();
                        });
    }

    @Test
    void anEmptyWorkspace() {
        assertThat(
                        Workspace.of(
                                        java.util.List.of(),
                                        Set.of("a/B.arc"),
                                        HouseLanguages.reader())
                                .components())
                .isEmpty();
    }
}
