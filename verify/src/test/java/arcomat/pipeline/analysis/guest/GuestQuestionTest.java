package arcomat.pipeline.analysis.guest;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.automaton.Analyses;
import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.OutsideQuestion;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.guest.AutomatonAnalysis;
import arcomat.guest.AutomatonRuns;
import arcomat.guest.host.Guests.Question;
import arcomat.model.Component;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/** What others ask about automata cannot take long, and is not answered by half. */
class GuestQuestionTest {
    private static final Duration SHORT = Duration.ofMillis(200);

    private static AutomatonAnalysis analysis(Consumer<AutomatonRuns> work) {
        return new AutomatonAnalysis() {
            @Override
            public List<String> codes() {
                return List.of("SLOW0001");
            }

            @Override
            public void examine(AutomatonRuns runs, Findings findings) {
                work.accept(runs);
            }
        };
    }

    /** Keeps the last number: with that there is no end of configurations, but proofs. */
    private static final Component HOLDS =
            ReadModels.model(
                            new SourceFile(
                                    "p/Holds.arc",
                                    """
                                    package p;

                                    component Holds {
                                        port in Integer seen, out Integer kept;

                                        <<completion = "ignore">> automaton {
                                            state only;
                                            variable Integer last = 0;
                                            initial only;
                                            only {seen == ?} / {kept = last, last = seen};
                                            only {seen == --} / {kept = last};
                                        }
                                    }
                                    """))
                    .component("p.Holds")
                    .orElseThrow();

    private static Examination examine(OutsideQuestion... outside) {
        Promise promise = Promise.of(HOLDS, List.of());
        return Analyses.examine(promise, List.of(outside), Budget.ofMemory()).get(0);
    }

    @Test
    void whatIsProvedIsNotProvedForGuests() {
        List<AutomatonRuns> asked = new ArrayList<>();
        Question silent = new Question("quiet", List.of(), analysis(asked::add));
        assertThat(examine().answer()).isEqualTo(Answer.HOLDS);
        Examination found = examine(new GuestQuestion(silent, SHORT.multipliedBy(100)));
        assertThat(found.answer()).isEqualTo(Answer.UNKNOWN);
        assertThat(found.obstacle()).startsWith("guests were asked about some of the config");
        assertThat(asked).singleElement().matches(runs -> !runs.whole());
    }

    @Test
    void whoTakesTooLongIsNotAskedAgainAndNotTakenForDone() {
        AtomicInteger asked = new AtomicInteger();
        AutomatonAnalysis endless =
                analysis(
                        runs -> {
                            asked.incrementAndGet();
                            while (!Thread.currentThread().isInterrupted()) {
                                Thread.onSpinWait();
                            }
                        });
        GuestQuestion question =
                new GuestQuestion(new Question("slow", endless.codes(), endless), SHORT);
        for (int i = 0; i < 2; i++) {
            assertThat(examine(question).findings())
                    .singleElement()
                    .satisfies(found -> assertThat(found.code()).isEqualTo("ARC1202"))
                    .satisfies(
                            found ->
                                    assertThat(found.diagnostic().message())
                                            .startsWith("guest 'slow' was not done"));
        }
        assertThat(asked).hasValue(1);
    }
}
