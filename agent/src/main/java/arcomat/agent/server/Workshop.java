package arcomat.agent.server;

import arcomat.agent.tool.Tool;
import arcomat.agent.tool.ToolAnswer;
import arcomat.agent.tool.ToolArguments;
import arcomat.agent.tool.ToolCall;
import arcomat.pipeline.LimitedProgress;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.TimeIsUp;
import arcomat.pipeline.WrongUse;
import arcomat.report.text.Printable;
import arcomat.sim.time.SecondsText;

import com.google.gson.JsonObject;

import java.nio.file.InvalidPathException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Where tools do their work: one call after the other, each with its time. Work asks itself whether
 * it is to go on; what does not ask in time is left to itself, and another thread does what comes
 * next.
 */
public final class Workshop implements AutoCloseable {
    /** Models nest as deep as their authors like, and what follows them is recursive. */
    private static final long STACK_BYTES = 512L << 20;

    /** Time beyond the end in which work is to notice that it is over. */
    private static final Duration GRACE = Duration.ofSeconds(5);

    /** Threads that nobody can end take a processor each. */
    private static final int MOST_THREADS = 4;

    private final Session session;
    private final List<String> roots;
    private final Duration patience;
    private final Duration grace;
    private final ThreadPoolExecutor executor =
            new ThreadPoolExecutor(
                    1,
                    1,
                    0,
                    TimeUnit.MILLISECONDS,
                    new LinkedBlockingQueue<>(),
                    work -> {
                        Thread thread = new Thread(null, work, "tools", STACK_BYTES);
                        thread.setDaemon(true);
                        return thread;
                    });

    /**
     * @param session of all calls
     * @param roots the model roots, as the user wrote them
     * @param patience time that a call may take
     */
    public Workshop(Session session, List<String> roots, Duration patience) {
        this(session, roots, patience, GRACE);
    }

    /** The same with another time beyond the end. */
    Workshop(Session session, List<String> roots, Duration patience, Duration grace) {
        this.session = session;
        this.roots = roots;
        this.patience = patience;
        this.grace = grace;
    }

    /** What came of a call: an answer, or why there is none. */
    record Outcome(ToolAnswer answer, boolean failed) {
        static Outcome failed(String why) {
            return new Outcome(new ToolAnswer(why), true);
        }
    }

    /** Calls a tool; that the outcome is cancelled ends the work. */
    CompletableFuture<Outcome> call(Tool tool, JsonObject arguments) {
        CompletableFuture<Outcome> outcome = new CompletableFuture<>();
        executor.execute(
                () -> {
                    if (!outcome.isDone()) {
                        watch(outcome);
                        outcome.complete(work(tool, arguments, outcome));
                    }
                });
        return outcome;
    }

    private void watch(CompletableFuture<Outcome> outcome) {
        CompletableFuture.delayedExecutor(patience.plus(grace).toNanos(), TimeUnit.NANOSECONDS)
                .execute(
                        () -> {
                            if (outcome.complete(Outcome.failed(tooLong("and it goes on")))) {
                                leaveIt();
                            }
                        });
    }

    private synchronized void leaveIt() {
        int threads = Math.min(MOST_THREADS, executor.getCorePoolSize() + 1);
        executor.setMaximumPoolSize(threads);
        executor.setCorePoolSize(threads);
    }

    private String tooLong(String how) {
        return "unknown: the time of "
                + SecondsText.of(patience)
                + " s is up, "
                + how
                + ". Ask for less, or start arcomat mcp with a longer --timeout";
    }

    private Outcome work(Tool tool, JsonObject arguments, CompletableFuture<Outcome> outcome) {
        long end = System.nanoTime() + patience.toNanos();
        Progress limited = new LimitedProgress(session.progress(), end);
        Session own = session.with(new CallProgress(limited, outcome::isDone));
        try {
            ToolArguments told = ToolArguments.of(arguments, tool.parameters());
            return new Outcome(tool.answer(new ToolCall(told, own, roots, patience)), false);
        } catch (WrongUse e) {
            return Outcome.failed(Printable.escape(e.getMessage()));
        } catch (InvalidPathException e) {
            return Outcome.failed(
                    "'" + Printable.escape(e.getInput()) + "' cannot be the name of a file");
        } catch (TimeIsUp e) {
            return Outcome.failed(tooLong(String.valueOf(e.getMessage())));
        } catch (OutOfMemoryError full) {
            return Outcome.failed("unknown: memory is full; JAVA_OPTS=-Xmx gives Java more");
        } catch (RuntimeException | Error e) { // one call that fails does not end the others
            return Outcome.failed(
                    "internal error, this is a fault of arcomat (" + e + "); please report it");
        }
    }

    /** Nothing more is done. */
    @Override
    public void close() {
        executor.shutdownNow();
    }
}
