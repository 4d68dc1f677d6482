package arcomat.report;

import static arcomat.report.ShownTracks.elements;
import static arcomat.report.ShownTracks.texts;
import static arcomat.report.ShownTracks.track;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Trace;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.simulate.RunStreamTests;
import arcomat.report.page.Page;
import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Timeline.Flaw;
import arcomat.report.page.Track;
import arcomat.report.run.StreamTestPage;
import arcomat.report.run.TracePage;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** What pages tell about runs and tests, before a browser shows it. */
class ResultPagesTest {
    @TempDir private Path folder;

    private void write(String file, String text) throws IOException {
        Files.writeString(folder.resolve(file), text);
    }

    private List<StreamTestResult> tests() throws WrongUse {
        return Session.in(folder, Progress.NONE)
                .run(new RunStreamTests(List.of(".")))
                .value()
                .orElseThrow();
    }

    @Test
    void aFailingTestShowsWhatWasExpected() throws Exception {
        write("Door.arc", DoorModel.DOOR);
        write(
                "DoorTest.mt",
                """
                testsuite DoorTest for Door {
                  test closes { input { button: <true, 4*Tk>; } expect { open: <true, Tk, false, 3*Tk>; } }
                }
                """);
        Page page = StreamTestPage.of("all", tests());
        Story story = page.stories().get(0);
        assertThat(page.tone()).isEqualTo(Tone.BAD);
        assertThat(texts(track(story, "open expected"))).containsExactly("true", "false", "-", "-");
        assertThat(texts(track(story, "open"))).containsExactly("true", "-", "-", "false");
        assertThat(story.timeline().flaws())
                .containsExactly(
                        new Flaw(
                                1,
                                "open",
                                "open: expected is false, sent is --; the model allows --"));
        assertThat(story.headline()).startsWith("failed: in slice 1");
    }

    @Test
    void aPartMayBeCalledState() throws Exception {
        write("Door.arc", DoorModel.DOOR);
        write(
                "House.arc",
                """
                component House {
                  timing instant;
                  port in Boolean button, out Boolean open;
                  component Door state;
                  connect button -> state.button;
                  connect state.open -> open;
                }
                """);
        write(
                "HouseTest.mt",
                """
                testsuite HouseTest for House {
                  test opens { input { button: <true>; } expect { open: <true>; } }
                }
                """);
        Trace trace = StreamTests.firstRun(tests().get(0).test());
        Story story = TracePage.of(trace, List.of()).stories().get(0);
        assertThat(texts(track(story, "state"))).containsExactly("opened");
        assertThat(texts(track(story, "state.left"))).containsExactly("2");
        assertThat(story.drawings()).extracting(Drawing::title).containsExactly("state");
    }

    /** A bell of two rooms: what is sent inside is told by its sender, once one slice later. */
    private static final String BELL =
            """
            component Bell {
              timing instant;
              port in Boolean button, out Boolean sound;
              component Hall {
                timing instant;
                port in Boolean button, out Boolean rings;
                component Wire wire;
                connect button -> wire.i;
                connect wire.o -> rings;
                component Wire {
                  timing TIMING;
                  port in Boolean i, out Boolean o;
                  <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s {i == true} / {o = true};
                  }
                }
              }
              component Hall hall;
              component Horn {
                timing instant;
                port in Boolean on, out Boolean sound;
                <<completion = "ignore">> automaton { state s; initial s; s {on == true} / {sound = true}; }
              }
              component Horn horn;
              connect button -> hall.button;
              connect hall.rings -> horn.on;
              connect horn.sound -> sound;
            }
            """;

    private Story bell(String timing, String input) throws Exception {
        write("Bell.arc", BELL.replace("TIMING", timing));
        write(
                "BellTest.mt",
                "testsuite BellTest for Bell { test rings { input { button: <"
                        + input
                        + ">; }"
                        + " expect { sound: <>; } } }");
        Trace trace = StreamTests.firstRun(tests().get(0).test(), true);
        return TracePage.of(trace, List.of()).stories().get(0);
    }

    @Test
    void whatPartsSendHasRowsAsTheArchitectureHas() throws Exception {
        Story story = bell("delayed", "Tk, true, Tk, Tk");
        assertThat(story.timeline().tracks())
                .filteredOn(track -> track.kind() != Track.Kind.REASON)
                .extracting(track -> track.group() + ": " + track.name())
                .containsExactly(
                        "inputs: button",
                        "outputs: sound",
                        "part hall: hall.rings",
                        "part hall.wire: hall.wire.o",
                        "part hall.wire: hall.wire",
                        "part horn: horn.sound",
                        "part horn: horn");
        assertThat(texts(track(story, "hall.wire.o"))).containsExactly("-", "-", "true");
        assertThat(texts(track(story, "hall.rings"))).containsExactly("-", "-", "true");
        assertThat(texts(track(story, "horn.sound"))).containsExactly("-", "-", "true");
        Drawing architecture = story.drawings().get(0);
        assertThat(architecture.title()).isEqualTo("Bell");
        assertThat(architecture.carried())
                .containsEntry("button", "button")
                .containsEntry("hall.button", "button")
                .containsEntry("hall.wire.i", "button")
                .containsEntry("hall.rings", "hall.rings")
                .containsEntry("horn.on", "hall.wire.o")
                .containsEntry("sound", "sound");
        assertThat(architecture.svg()).contains("data-connector=\"hall.rings -&gt; horn.on\"");
    }

    @Test
    void whatPartsSendInAnEventIsTold() throws Exception {
        write(
                "Bell.arc",
                BELL.replace("TIMING", "untimed").replace("timing instant", "timing untimed"));
        write(
                "BellTest.mt",
                """
                testsuite BellTest for Bell {
                  test rings { events { button: false; button: true; } expect { sound: <true>; } }
                }
                """);
        Story story = StreamTestPage.of("all", tests()).stories().get(0);
        assertThat(texts(track(story, "hall.rings"))).containsExactly("-", "true");
        assertThat(texts(track(story, "horn.sound"))).containsExactly("-", "true");
    }

    /** Who has not listened does not say that there was silence. */
    @Test
    void nothingIsToldOfPartsThatNobodyListenedTo() throws Exception {
        write("Bell.arc", BELL.replace("TIMING", "instant"));
        write(
                "BellTest.mt",
                "testsuite BellTest for Bell { test rings { input { button: <true>; }"
                        + " expect { sound: <true>; } } }");
        Trace trace = StreamTests.firstRun(tests().get(0).test());
        Story story = TracePage.of(trace, List.of()).stories().get(0);
        assertThat(story.timeline().tracks()).extracting(Track::name).doesNotContain("hall.rings");
        assertThat(story.drawings()).extracting(Drawing::title).doesNotContain("Bell");
    }

    @Test
    void statesAndTransitionsAreMarked() throws Exception {
        write("Door.arc", DoorModel.DOOR);
        write(
                "DoorTest.mt",
                """
                testsuite DoorTest for Door {
                  test closes { input { button: <Tk, true, 4*Tk>; } expect { open: <Tk, true, 3*Tk, false>; } }
                }
                """);
        Trace trace = StreamTests.firstRun(tests().get(0).test());
        Story story = TracePage.of(trace, List.of()).stories().get(0);
        assertThat(texts(track(story, "state")))
                .containsExactly("closed", "opened", "opened", "opened", "closed");
        assertThat(elements(track(story, "state")).get(1)).containsExactly("state 1");
        assertThat(track(story, "state").before()).isEqualTo("closed");
        assertThat(texts(track(story, "left"))).containsExactly("0", "2", "1", "0", "0");
        assertThat(elements(track(story, "state because")))
                .containsExactly(
                        List.of(),
                        List.of("transition 0"),
                        List.of("transition 1"),
                        List.of("transition 1"),
                        List.of("transition 2"));
        assertThat(story.drawings())
                .singleElement()
                .satisfies(
                        drawing ->
                                assertThat(drawing.svg())
                                        .contains("data-state=\"1\"", "data-transition=\"2\""));
    }

    @Test
    void aTestTellsWhatDidNotFire() throws Exception {
        write("Door.arc", DoorModel.DOOR);
        write(
                "DoorTest.mt",
                """
                testsuite DoorTest for Door {
                  test waits { input { button: <Tk, true, Tk, 3*Tk, false, Tk>; } expect { open: <2*Tk, true>; } }
                }
                """);
        Story tested = StreamTestPage.of("all", tests()).stories().get(0);
        assertThat(texts(track(tested, "state why not")))
                .containsExactly(
                        "closed -> opened (line 8) did not fire: button == true: button is silent",
                        "-",
                        "-",
                        "-",
                        "-",
                        "closed -> opened (line 8) did not fire: button == true: button is false");
        Trace trace = StreamTests.firstRun(tests().get(0).test());
        assertThat(TracePage.of(trace, List.of()).stories().get(0).timeline().tracks())
                .noneMatch(track -> track.name().endsWith("why not"));
    }

    @Test
    void theSliceInWhichARunErrsIsThere() throws Exception {
        write(
                "Up.arc",
                """
                component Up {
                  port in Boolean up, out Integer[0..1] n;
                  automaton {
                    variable Integer[0..1] now = 0;
                    state s;
                    initial s / {n = 0};
                    s {up == true} / {now = now + 1, n = now + 1};
                  }
                }
                """);
        write(
                "UpTest.mt",
                """
                testsuite UpTest for Up {
                  test ends { input { up: <true, Tk, true, Tk>; } expect { n: <0, Tk, 0, Tk>; } }
                }
                """);
        Trace trace = StreamTests.firstRun(tests().get(0).test());
        Story story = TracePage.of(trace, List.of()).stories().get(0);
        assertThat(texts(track(story, "n"))).containsExactly("0", "1");
        assertThat(texts(track(story, "state"))).containsExactly("s", "s");
        assertThat(story.timeline().flaws()).extracting(Flaw::at).containsExactly(1);
        Story tested = StreamTestPage.of("all", tests()).stories().get(0);
        assertThat(texts(track(tested, "n expected"))).containsExactly("0", "0");
        assertThat(tested.timeline().length()).isEqualTo(2);
    }

    @Test
    void aMessageOfAnEventIsFoundInItsEvent() throws Exception {
        write(
                "Echo.arc",
                """
                component Echo {
                  timing untimed;
                  port in Integer i, out Integer o;
                  <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s {i == 1} / {o = 1};
                  }
                }
                """);
        write(
                "EchoTest.mt",
                """
                testsuite EchoTest for Echo {
                  test twice { events { i: 2; i: 1; i: 2; i: 1; } expect { o: <1, 2>; } }
                }
                """);
        Story story = StreamTestPage.of("all", tests()).stories().get(0);
        assertThat(story.timeline().flaws()).extracting(Flaw::at).containsExactly(3);
    }

    /** What could not be decided is neither good news nor bad. */
    @Test
    void anUnknownTestIsOpen() throws Exception {
        write(
                "Guess.arc",
                """
                component Guess {
                  timing instant;
                  port in Boolean go, out Integer n;
                  <<completion = "output">> automaton { state s; initial s; }
                }
                """);
        write(
                "Twice.arc",
                """
                component Twice {
                  timing instant;
                  port in Integer n, out Integer o;
                  <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s {n == ?} / {o = n * 2};
                  }
                }
                """);
        write(
                "Both.arc",
                """
                component Both {
                  timing instant;
                  port in Boolean go, out Integer o;
                  component Guess guess;
                  component Twice twice;
                  connect go -> guess.go;
                  connect guess.n -> twice.n;
                  connect twice.o -> o;
                }
                """);
        write(
                "BothTest.mt",
                """
                testsuite BothTest for Both {
                  test zero { input { go: <Tk>; } expect { o: <0, Tk>; } }
                  test doubles { input { go: <Tk>; } expect { o: <42, Tk>; } }
                }
                """);
        Page page = StreamTestPage.of("tests", tests());
        assertThat(page.tone()).isEqualTo(Tone.OPEN);
        assertThat(page.stories()).extracting(Story::tone).containsExactly(Tone.GOOD, Tone.OPEN);
        assertThat(page.stories().get(1).headline()).startsWith("unknown: ");
        assertThat(page.stories().get(1).timeline().flaws()).isEmpty();
    }
}
