package arcomat.pipeline.watch;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.watch.WatchStatus.Standing;
import arcomat.pipeline.watch.WatchStatus.State;
import arcomat.pipeline.watch.WatchStatus.Step;
import arcomat.source.Diagnostic;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;

/** Saves files, and waits until what is broken is told. */
class WatchModelsTest {
    private static final long PATIENCE_SECONDS = 120;

    private static final String LAMP =
            """
            package p;

            component Lamp {
                timing instant;
                port <<total>> in Boolean button, <<total>> out Boolean light;

                automaton {
                    state only;
                    initial only;
                    only {button == true} / {light = true};
                    only {button == false} / {light = false};
                }
            }
            """;

    private static final String TEST =
            """
            package p;

            testsuite LampTest for Lamp {
                test shines { input { button: <true, Tk>; } expect { light: <true, Tk>; } }
            }
            """;

    private static final String NUMBER =
            """
            package p;

            component Number(Integer[0..9] n) {
                timing instant;
                port <<total>> in Boolean i, <<total>> out Integer[0..9] o;
                inv small: o < 3;

                automaton {
                    state only;
                    initial only;
                    only / {o = n};
                }
            }
            """;

    @TempDir private Path folder;

    private final BlockingQueue<WatchStatus> settled = new LinkedBlockingQueue<>();
    private Thread watching;

    private static String user(String name, int number) {
        return """
        package p;

        component %s {
            port <<total>> in Boolean i, <<total>> out Integer[0..9] o;
            component Number(%d) number;
            connect i -> number.i;
            connect number.o -> o;
        }
        """
                .formatted(name, number);
    }

    private void save(String file, String text) throws IOException {
        Path path = folder.resolve(file);
        Files.createDirectories(path.getParent());
        Files.writeString(path, text);
    }

    /** As many editors do. */
    private void saveByRename(String file, String text) throws IOException {
        Path beside = folder.resolve(file + "~");
        Files.writeString(beside, text);
        Files.move(beside, folder.resolve(file), StandardCopyOption.REPLACE_EXISTING);
    }

    private void watch(boolean polling) {
        Listener listener =
                new Listener() {
                    @Override
                    public void changed(Collection<String> files) {}

                    @Override
                    public void done(Done what, WatchStatus now) {}

                    @Override
                    public void settled(WatchStatus now) {
                        settled.add(now);
                    }
                };
        WatchModels task =
                new WatchModels(
                        List.of("m"), false, polling, Duration.ofSeconds(60), "test", listener);
        watching =
                new Thread(
                        () -> {
                            try {
                                Session.in(folder, Progress.NONE).run(task);
                            } catch (Exception e) {
                                throw new AssertionError(e);
                            }
                        });
        watching.start();
    }

    private WatchStatus until(Predicate<WatchStatus> wanted) throws InterruptedException {
        WatchStatus last = null;
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (System.nanoTime() < end) {
            WatchStatus next = settled.poll(1, TimeUnit.SECONDS);
            last = next == null ? last : next;
            if (next != null && wanted.test(next)) {
                return next;
            }
        }
        throw new AssertionError("it never came to that; last: " + last);
    }

    private static boolean isFine(WatchStatus now) {
        return now.standing() == Standing.FINE;
    }

    private static boolean isBroken(WatchStatus now) {
        return now.standing() == Standing.BROKEN;
    }

    @AfterEach
    void end() throws InterruptedException {
        if (watching != null) {
            watching.interrupt();
            watching.join();
        }
    }

    @ParameterizedTest(name = "polling {0}")
    @ValueSource(booleans = {false, true})
    void tellsWhatEachSaveBreaksAndMends(boolean polling) throws Exception {
        save("m/p/Lamp.arc", LAMP);
        save("m/p/LampTest.mt", TEST);
        watch(polling);
        assertThat(until(WatchModelsTest::isFine).tests()).hasSize(1);

        save("m/p/Lamp.arc", LAMP.replace("light = true", "light = false"));
        WatchStatus failing = until(WatchModelsTest::isBroken);
        assertThat(failing.check().findings()).noneMatch(Diagnostic::isError);
        assertThat(failing.tests()).hasSize(1);

        save("m/p/Lamp.arc", LAMP.substring(0, LAMP.length() / 2));
        WatchStatus half = until(now -> now.check().hasErrors());
        assertThat(half.tests()).isEmpty();
        assertThat(half.state(Step.TEST)).isEqualTo(State.BLOCKED);

        saveByRename("m/p/Lamp.arc", LAMP);
        assertThat(until(WatchModelsTest::isFine).tests()).hasSize(1);

        Files.delete(folder.resolve("m/p/LampTest.mt"));
        assertThat(until(now -> now.check().files() == 1).tests()).isEmpty();
    }

    @Test
    void seesFoldersComeAndGo() throws Exception {
        save("m/p/Lamp.arc", LAMP);
        watch(false);
        until(WatchModelsTest::isFine);

        save("m/q/r/Other.arc", LAMP.replace("package p", "package q.r"));
        assertThat(until(WatchModelsTest::isBroken).check().files()).isEqualTo(2);

        save("m/q/r/Other.arc", LAMP.replace("package p", "package q.r").replace("Lamp", "Other"));
        until(WatchModelsTest::isFine);

        Files.move(folder.resolve("m/q"), folder.resolve("gone"));
        assertThat(until(now -> now.check().files() == 1).standing()).isEqualTo(Standing.FINE);

        Files.move(folder.resolve("gone"), folder.resolve("m/q"));
        assertThat(until(now -> now.check().files() == 2).standing()).isEqualTo(Standing.FINE);

        save("m/q/r/Other.arc", "component");
        until(WatchModelsTest::isBroken);
    }

    /**
     * Whether a component keeps an invariant depends on who uses it: nobody else may have changed.
     */
    @Test
    void asksAgainWhatAUserOfAComponentChanges() throws Exception {
        save("m/p/Number.arc", NUMBER);
        save("m/p/Low.arc", user("Low", 1));
        save("m/p/High.arc", user("High", 2));
        watch(false);
        assertThat(titles(until(WatchModelsTest::isFine))).contains("p.Number(1)", "p.Number(2)");

        save("m/p/High.arc", user("High", 3));
        WatchStatus broken = until(WatchModelsTest::isBroken);
        assertThat(titles(broken)).contains("p.Number(1)", "p.Number(3)");
        assertThat(broken.promises())
                .filteredOn(each -> each.verdict().answer() == Answer.FAILS)
                .extracting(Answered::left)
                .contains("p.Number(3)");

        Files.delete(folder.resolve("m/p/High.arc"));
        assertThat(titles(until(WatchModelsTest::isFine)))
                .contains("p.Number(1)")
                .doesNotContain("p.Number(3)");
    }

    private static List<String> titles(WatchStatus now) {
        return now.promises().stream().map(Answered::left).toList();
    }

    @Test
    void runsWorldsThatAChangeTouches() throws Exception {
        save("m/yard.world", "floor 1000 1000\nseconds 1\n");
        save("m/p/Lamp.arc", LAMP);
        watch(false);
        WatchStatus first = until(now -> !now.worlds().isEmpty());
        save("m/p/Lamp.arc", LAMP.replace("light = true", "light = false"));
        assertThat(until(now -> true).worlds()).isEqualTo(first.worlds());
        save("m/yard.world", "floor 1000\nseconds 1\n");
        assertThat(until(now -> !now.worlds().get(0).succeeded()).worlds()).hasSize(1);
        Files.delete(folder.resolve("m/yard.world"));
        assertThat(until(now -> now.worlds().isEmpty()).standing()).isEqualTo(Standing.FINE);
    }

    @Test
    void looksOnceWhereItIsTold() throws Exception {
        save("m/p/Lamp.arc", LAMP);
        save("m/p/LampTest.mt", TEST.replace("light: <true", "light: <false"));
        Listener nobody =
                new Listener() {
                    @Override
                    public void changed(Collection<String> files) {}

                    @Override
                    public void done(Done what, WatchStatus now) {}

                    @Override
                    public void settled(WatchStatus now) {}
                };
        WatchStatus now =
                Session.in(folder, Progress.NONE)
                        .run(
                                new WatchModels(
                                        List.of("m"),
                                        true,
                                        false,
                                        Duration.ofSeconds(60),
                                        "test",
                                        nobody));
        assertThat(now.standing()).isEqualTo(Standing.BROKEN);
        assertThat(now.tests()).hasSize(1);
    }
}
