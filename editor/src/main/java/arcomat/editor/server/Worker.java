package arcomat.editor.server;

import arcomat.editor.desk.Desk;
import arcomat.guest.host.Guests;

import org.eclipse.lsp4j.jsonrpc.CancelChecker;
import org.eclipse.lsp4j.jsonrpc.CompletableFutures;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.BiFunction;
import java.util.function.Consumer;

/**
 * The one thread that works on the desk: edits and questions in the order in which they come, so
 * that a question sees all edits before it, and checks whenever there is nothing else to do. A
 * check is broken off where something else comes, and begun again after that.
 */
final class Worker {
    /** Who types on and on sees findings nevertheless, in what is on the screen. */
    private static final Duration LONGEST_WAIT = Duration.ofMillis(500);

    /** And in the other files, some of them at a time. */
    private static final Duration LONGEST_WAIT_OF_OTHERS = Duration.ofSeconds(5);

    private final Desk desk;
    private final Consumer<Desk> checked;
    private final ThreadPoolExecutor executor =
            new ThreadPoolExecutor(
                    1,
                    1,
                    0,
                    TimeUnit.MILLISECONDS,
                    new LinkedBlockingQueue<>(),
                    new DeepThreads("desk"));

    /** Of what is on the screen. */
    private boolean needsCheck;

    private boolean othersNeedCheck;
    private boolean checkIsQueued;
    private long neededSince;
    private long othersNeededSince;

    /** Ends a check because something else has come. */
    private static final class BrokenOff extends RuntimeException {
        private static final long serialVersionUID = 1;

        private BrokenOff() {
            super(null, null, false, false);
        }
    }

    /**
     * @param guests who bring laws and behaviour languages
     * @param checked told after each check
     */
    Worker(Guests guests, Consumer<Desk> checked) {
        this.desk = new Desk(guests);
        this.checked = checked;
    }

    /** Does something that may change what is found. */
    void edit(Consumer<Desk> edit) {
        executor.execute(
                () -> {
                    edit.accept(desk);
                    needCheck();
                    checkLater();
                });
    }

    private void needCheck() {
        if (!needsCheck) {
            needsCheck = true;
            neededSince = System.nanoTime();
        }
        if (!othersNeedCheck) {
            othersNeedCheck = true;
            othersNeededSince = System.nanoTime();
        }
    }

    /** There is one check in the queue at most, so that two do not wait for one another. */
    private void checkLater() {
        if (checkIsQueued) {
            return;
        }
        try {
            executor.execute(this::checkIfIdle);
            checkIsQueued = true;
        } catch (RejectedExecutionException over) {
            // The editor takes its leave, and nobody looks at findings any longer.
        }
    }

    /** Answers a question about the texts as they are now. */
    <T> CompletableFuture<T> ask(BiFunction<Desk, CancelChecker, T> question) {
        return CompletableFutures.computeAsync(
                executor,
                canceled -> {
                    canceled.checkCanceled();
                    return question.apply(desk, canceled);
                });
    }

    /**
     * Answers a question about what is found in the texts as they are now.
     *
     * @param file on which alone the answer depends, where there is one
     */
    <T> CompletableFuture<T> askChecked(
            Optional<Path> file, BiFunction<Desk, CancelChecker, T> question) {
        return ask(
                (any, canceled) -> {
                    if (file.flatMap(desk::onScreen).isPresent()) {
                        checkScreen(() -> {});
                    } else {
                        checkAll();
                    }
                    return question.apply(any, canceled);
                });
    }

    private void checkIfIdle() {
        checkIsQueued = false;
        try {
            readAll();
            breakOffForScreen();
            checkScreen(this::breakOffForScreen);
            checkOthers();
        } catch (BrokenOff others) {
            checkLater();
        }
    }

    /** Who opens a file meanwhile, as editors do when they have started, is asked for at once. */
    private void readAll() {
        while (desk.readSome()) {
            if (!executor.getQueue().isEmpty()) {
                throw new BrokenOff();
            }
        }
    }

    private void breakOffForScreen() {
        if (needsCheck) {
            breakOff(neededSince, LONGEST_WAIT);
        }
    }

    private void breakOffForOthers() {
        breakOff(othersNeededSince, LONGEST_WAIT_OF_OTHERS);
    }

    private void breakOff(long since, Duration longest) {
        boolean waited = System.nanoTime() - since > longest.toNanos();
        if (!waited && !executor.getQueue().isEmpty()) {
            throw new BrokenOff();
        }
    }

    private void checkScreen(Runnable goOn) {
        if (needsCheck) {
            desk.checkScreen(goOn);
            needsCheck = false;
            checked.accept(desk);
        }
    }

    /** What was done stays done, whoever breaks in. */
    private void checkOthers() {
        while (othersNeedCheck) {
            breakOffForOthers();
            if (desk.checkSome(this::breakOffForOthers)) {
                othersNeededSince = System.nanoTime();
            } else {
                othersNeedCheck = false;
                checked.accept(desk);
            }
        }
    }

    private void checkAll() {
        if (needsCheck || othersNeedCheck) {
            desk.check(() -> {});
            needsCheck = false;
            othersNeedCheck = false;
            checked.accept(desk);
        }
    }

    /** Finishes what was begun. */
    void end() {
        executor.shutdown();
    }
}
