package arcomat.pipeline;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.check.Checks;
import arcomat.check.LawBook;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.pipeline.check.CheckedModels;
import arcomat.semantics.Promise;
import arcomat.symbols.Workspace;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/** Every step of the way to an answer ends when the time is up. */
class TimeIsUpTest {
    /** More than are made between two looks at the clock. */
    private static final int PARTS = 20;

    private static final Runnable NEVER =
            () -> {
                throw new TimeIsUp("working");
            };

    @TempDir private Path folder;

    @BeforeEach
    void writeManyParts() throws Exception {
        Files.writeString(
                folder.resolve("Part.arc"),
                """
                component Part {
                  port in Boolean i, out Boolean o;
                  automaton { state s; initial s; s {i == true} / {o = true}; }
                }
                """);
        Files.writeString(folder.resolve("Row.arc"), row("Row", "Part"));
        Files.writeString(folder.resolve("Field.arc"), row("Field", "Row"));
        Files.writeString(
                folder.resolve("Other.arc"), row("Other", "Row").replace("p0.o -> o", "p1.o -> o"));
    }

    private static String row(String name, String part) {
        StringBuilder text = new StringBuilder("component " + name + " {\n");
        text.append("  port in Boolean i, out Boolean o;\n");
        for (int i = 0; i < PARTS; i++) {
            text.append("  component %s p%d;\n  connect i -> p%d.i;\n".formatted(part, i, i));
        }
        return text.append("  connect p0.o -> o;\n}\n").toString();
    }

    private CheckedModels check(Progress progress) {
        return CheckedModels.check(
                List.of("."), Profile.REQUIREMENTS, Session.in(folder, progress));
    }

    @Test
    void reading() {
        Progress late = new LimitedProgress(Progress.NONE, System.nanoTime());
        assertThatThrownBy(() -> check(late))
                .isInstanceOf(TimeIsUp.class)
                .hasMessage("the time is up while reading 4 files");
    }

    @Test
    void checkingAndLowering() {
        Workspace workspace = check(Progress.NONE).workspace();
        assertThatThrownBy(
                        () ->
                                Checks.review(
                                        LawBook.OWN,
                                        workspace,
                                        Profile.REQUIREMENTS,
                                        unit -> true,
                                        NEVER))
                .isInstanceOf(TimeIsUp.class);
        assertThatThrownBy(() -> Lowering.lower(workspace, NEVER)).isInstanceOf(TimeIsUp.class);
    }

    @Test
    void eachStepOfTheWayAsks() {
        AtomicInteger asked = new AtomicInteger();
        Workspace workspace =
                check(
                                new Progress() {
                                    @Override
                                    public void step(String what) {}

                                    @Override
                                    public void goOn() {
                                        asked.incrementAndGet();
                                    }
                                })
                        .workspace();
        // Four files are read, parsed and checked; then there are the laws about all of them.
        assertThat(asked.get()).isEqualTo(4 + 4 + 4 + 1);
        Lowering.lower(workspace, asked::incrementAndGet);
        assertThat(asked.get()).isEqualTo(4 + 4 + 4 + 1 + 4);
    }

    /** The clock strikes at the first look, which is before all parts are there. */
    @Test
    void unfolding() {
        var model = Lowering.lower(check(Progress.NONE).workspace());
        Component left = model.component("Field").orElseThrow();
        Component right = model.component("Other").orElseThrow();
        AtomicInteger looks = new AtomicInteger();
        Verdict verdict =
                Refinement.check(
                        new Promise(left, List.of(), left.automata()),
                        new Promise(right, List.of(), right.automata()),
                        new Budget(() -> looks.incrementAndGet() > 0, 1000));
        assertThat(verdict.answer()).isEqualTo(Verdict.Answer.UNKNOWN);
        assertThat(verdict.reason()).isEqualTo("the time is up");
        assertThat(looks.get()).isEqualTo(1);
    }
}
