package arcomat.agent.server;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.agent.server.Workshop.Outcome;
import arcomat.agent.tool.Tool;
import arcomat.agent.tool.ToolAnswer;
import arcomat.agent.tool.ToolCall;
import arcomat.agent.tool.ToolParameter;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;

import com.google.gson.JsonObject;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

/** Calls that take long, fail, or are given up. */
class WorkshopTest {
    private static final long PATIENCE = 120;

    private final Session session = new Session(new PathNames(Path.of("")), Progress.NONE);
    private final Workshop workshop =
            new Workshop(session, List.of("models"), Duration.ofSeconds(1));

    @AfterEach
    void close() {
        workshop.close();
    }

    private record Doing(Function<ToolCall, ToolAnswer> work) implements Tool {
        @Override
        public String name() {
            return "doing";
        }

        @Override
        public String description() {
            return "does it";
        }

        @Override
        public List<ToolParameter> parameters() {
            return List.of();
        }

        @Override
        public ToolAnswer answer(ToolCall call) {
            return work.apply(call);
        }
    }

    private CompletableFuture<Outcome> call(Function<ToolCall, ToolAnswer> work) {
        return call(workshop, work);
    }

    private static CompletableFuture<Outcome> call(
            Workshop asked, Function<ToolCall, ToolAnswer> work) {
        return asked.call(new Doing(work), new JsonObject());
    }

    private static Outcome get(CompletableFuture<Outcome> outcome) throws Exception {
        return outcome.get(PATIENCE, TimeUnit.SECONDS);
    }

    private static ToolAnswer askForever(ToolCall call) {
        while (true) {
            call.session().progress().goOn();
        }
    }

    @Test
    void workThatAsksEndsWithItsTime() throws Exception {
        Outcome late = get(call(WorkshopTest::askForever));
        assertThat(late.failed()).isTrue();
        assertThat(late.answer().text()).startsWith("unknown: the time of 1 s is up");
        assertThat(get(call(next -> new ToolAnswer("next"))).answer().text()).isEqualTo("next");
    }

    @Test
    void workThatDoesNotAskIsLeftToItself() throws Exception {
        CountDownLatch never = new CountDownLatch(1);
        Duration soon = Duration.ofMillis(200);
        Workshop hasty = new Workshop(session, List.of("models"), soon, soon);
        CompletableFuture<Outcome> stuck =
                call(
                        hasty,
                        any -> {
                            try {
                                never.await();
                            } catch (InterruptedException e) {
                                Thread.currentThread().interrupt();
                            }
                            return new ToolAnswer("late");
                        });
        CompletableFuture<Outcome> next = call(hasty, any -> new ToolAnswer("next"));
        assertThat(get(stuck).answer().text()).contains("and it goes on");
        assertThat(get(next).answer().text()).isEqualTo("next");
        never.countDown();
        hasty.close();
    }

    @Test
    void workThatIsCancelledEnds() throws Exception {
        CountDownLatch begun = new CountDownLatch(1);
        CountDownLatch ended = new CountDownLatch(1);
        CompletableFuture<Outcome> cancelled =
                call(
                        work -> {
                            begun.countDown();
                            try {
                                return askForever(work);
                            } finally {
                                ended.countDown();
                            }
                        });
        assertThat(begun.await(PATIENCE, TimeUnit.SECONDS)).isTrue();
        cancelled.cancel(true);
        assertThat(ended.await(PATIENCE, TimeUnit.SECONDS)).isTrue();
    }

    @Test
    void aFaultIsToldAndTheNextCallIsAnswered() throws Exception {
        Outcome fault =
                get(
                        call(
                                any -> {
                                    throw new IllegalStateException("oh");
                                }));
        assertThat(fault.answer().text()).startsWith("internal error, this is a fault of arcomat");
        Outcome full =
                get(
                        call(
                                any -> {
                                    throw new OutOfMemoryError();
                                }));
        assertThat(full.answer().text()).startsWith("unknown: memory is full");
        assertThat(get(call(next -> new ToolAnswer("next"))).failed()).isFalse();
    }
}
