package arcomat.report;

import static arcomat.report.ShownTracks.texts;
import static arcomat.report.ShownTracks.track;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Answered;
import arcomat.model.Trace;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.VerifyPromises;
import arcomat.pipeline.simulate.RunStreamTests;
import arcomat.report.page.Page;
import arcomat.report.page.Page.Tone;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Timeline.Flaw;
import arcomat.report.page.Track;
import arcomat.report.run.StreamTestPage;
import arcomat.report.run.TracePage;
import arcomat.report.verdict.VerdictPage;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What pages tell about results, before a browser shows it. */
class ResultPagesTest {
    private static final String DOOR =
            """
            component Door {
              timing instant;
              port in Boolean button, out Boolean open;
              <<completion = "ignore">> automaton {
                variable Integer[0..9] left = 0;
                state closed, opened;
                initial closed;
                closed -> opened {button == true} / {open = true, left = 2};
                opened [left > 0] / {left = left - 1};
                opened -> closed [left == 0] / {open = false};
              }
            }
            """;

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

    private Story firstVerdict() throws WrongUse {
        AnalysisLimits limits = new AnalysisLimits(Optional.empty(), Optional.empty());
        List<Answered> answers =
                Session.in(folder, Progress.NONE)
                        .run(new VerifyPromises(List.of("."), limits))
                        .value()
                        .orElseThrow();
        return VerdictPage.of("verify", "all", answers, "none").stories().get(0);
    }

    /** The elements of drawings that a track marks, step by step. */
    private static List<List<String>> elements(Track track) {
        List<List<String>> elements = new ArrayList<>();
        for (Track.Run run : track.runs()) {
            for (int i = 0; i < run.length(); i++) {
                elements.add(
                        run.value() < 0 ? List.of() : track.values().get(run.value()).elements());
            }
        }
        return elements;
    }

    @Test
    void aFailingTestShowsWhatWasExpected() throws Exception {
        write("Door.arc", DOOR);
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
    void whatHoldsNamesTheCommandThatWritesDownWhy() throws Exception {
        write("Door.arc", DOOR.replace("<<completion", "inv closes: left < 3; <<completion"));
        assertThat(firstVerdict().facts())
                .anyMatch(fact -> fact.text().startsWith("'arcomat verify --certificate FILE'"));
        Files.delete(folder.resolve("Door.arc"));
        write("House.arc", DOOR.replace("Door", "House"));
        write("Door.arc", DOOR.replace("component Door {", "component Door refines House {"));
        assertThat(firstVerdict().facts())
                .anyMatch(fact -> fact.text().startsWith("'arcomat refines --certificate FILE'"));
    }

    @Test
    void aPartMayBeCalledState() throws Exception {
        write("Door.arc", DOOR);
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
        write("Door.arc", DOOR);
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
        write("Door.arc", DOOR);
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
    void aCounterexampleGoesThroughBothAutomata() throws Exception {
        write("Door.arc", DOOR);
        write(
                "Late.arc",
                DOOR.replace("component Door", "component Late refines Door")
                        .replace("left = 2", "left = 3"));
        Story story = firstVerdict();
        assertThat(texts(track(story, "right is")).get(4)).isEqualTo("not possible");
        assertThat(elements(track(story, "left: Late goes")))
                .containsExactly(
                        List.of("state 0", "initial 0"),
                        List.of("state 1", "transition 0"),
                        List.of("state 1", "transition 1"),
                        List.of("state 1", "transition 1"),
                        List.of("state 1", "transition 1"));
        assertThat(elements(track(story, "right: Door goes")).get(3))
                .containsExactly("state 1", "transition 1");
        assertThat(elements(track(story, "right: Door goes")).get(4)).isEmpty();
        assertThat(story.timeline().flaws()).extracting(Flaw::at).containsExactly(4);
    }

    /** The side that does nothing says which transition came nearest; the other one goes. */
    @Test
    void aCounterexampleSaysWhyNot() throws Exception {
        String guarded =
                """
                component Guarded {
                  port in Boolean x, out Boolean y;
                  <<completion = "ignore">> automaton {
                    state a, b;
                    initial a;
                    a -> b {x == true} / {y = true};
                    b -> a {x == false} / {y = true};
                  }
                }
                """;
        write("Guarded.arc", guarded);
        write(
                "Eager.arc",
                guarded.replace("component Guarded", "component Eager refines Guarded")
                        .replace("b -> a {x == false}", "b -> a {x == true}"));
        Story story = firstVerdict();
        assertThat(texts(track(story, "left: Eager why not")))
                .containsExactly(
                        "-", "-", "left: b -> a (line 7) did not fire: x == true: x is false");
        assertThat(story.timeline().tracks())
                .extracting(Track::name)
                .doesNotContain("right: Guarded why not");
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

    /**
     * A chain of two parts, the first of which may send either message: only the second alternative
     * leads to what the promise forbids, which is seen one slice after it was sent.
     */
    private static final String CHAIN =
            """
            component Chain PROMISE {
              port in Boolean go, out Boolean on;
              INVARIANT
              component Maybe {
                timing instant;
                port in Boolean go, out Boolean said;
                <<completion = "ignore">> automaton {
                  state calm, loud;
                  initial calm;
                  calm {go == true} / {said = false};
                  calm -> loud {go == true} / {said = true};
                }
              }
              component Maybe maybe;
              component Repeat {
                port in Boolean i, out Boolean o;
                <<completion = "ignore">> automaton {
                  state s;
                  initial s / {o = false};
                  s {i == true} / {o = true};
                }
              }
              component Repeat repeat;
              connect go -> maybe.go;
              connect maybe.said -> repeat.i;
              connect repeat.o -> on;
            }
            """;

    private void never() throws IOException {
        write(
                "Never.arc",
                """
                component Never {
                  port in Boolean go, out Boolean on;
                  <<completion = "ignore">> automaton { state n; initial n / {on = false}; }
                }
                """);
    }

    @Test
    void aCounterexampleTellsWhatPartsSend() throws Exception {
        never();
        write("Chain.arc", CHAIN.replace("PROMISE", "refines Never").replace("INVARIANT", ""));
        Story story = firstVerdict();
        assertThat(texts(track(story, "on"))).containsExactly("false", "true");
        assertThat(texts(track(story, "left is")))
                .containsExactly("maybe: calm, repeat: s", "maybe: loud, repeat: s");
        assertThat(track(story, "maybe.said").group()).isEqualTo(Track.PART + "maybe");
        assertThat(texts(track(story, "maybe.said"))).containsExactly("-", "true");
        assertThat(texts(track(story, "repeat.o"))).containsExactly("false", "true");
        assertThat(texts(track(story, "maybe"))).containsExactly("calm", "loud");
        assertThat(elements(track(story, "maybe because")))
                .containsExactly(List.of(), List.of("transition 1"));
        assertThat(story.drawings())
                .extracting(Drawing::title)
                .containsExactly("left: Chain", "left: maybe", "left: repeat", "right: Never");
        assertThat(story.drawings().get(0).carried())
                .containsEntry("maybe.said", "maybe.said")
                .containsEntry("repeat.i", "maybe.said")
                .containsEntry("on", "on");
    }

    /**
     * As far as it can follow; where it cannot, its parts send nothing and stay where they were.
     */
    @Test
    void aCounterexampleTellsWhatPartsOfTheRightSideSend() throws Exception {
        write("Chain.arc", CHAIN.replace("PROMISE", "").replace("INVARIANT", ""));
        write(
                "Loud.arc",
                """
                component Loud refines Chain {
                  port in Boolean go, out Boolean on;
                  <<completion = "ignore">> automaton {
                    state a, b;
                    initial a / {on = false};
                    a -> b {go == true} / {on = true};
                    b {go == false} / {on = true};
                  }
                }
                """);
        Story story = firstVerdict();
        assertThat(texts(track(story, "on"))).containsExactly("false", "true", "true");
        assertThat(track(story, "right: maybe.said").group())
                .isEqualTo(Track.PART + "right: maybe");
        assertThat(texts(track(story, "right: maybe.said"))).containsExactly("-", "true", "-");
        assertThat(texts(track(story, "right: repeat.o"))).containsExactly("false", "true", "-");
        assertThat(texts(track(story, "right: maybe"))).containsExactly("calm", "loud", "loud");
        assertThat(story.drawings())
                .extracting(Drawing::title)
                .containsExactly("right: Chain", "right: maybe", "right: repeat", "left: Loud");
        assertThat(story.drawings().get(0).carried())
                .containsEntry("repeat.i", "right: maybe.said")
                .containsEntry("go", "go")
                .doesNotContainKey("on");
        assertThat(story.drawings().get(1).tracks())
                .containsExactly("right: maybe", "right: maybe because");
    }

    /** Of an invariant a step is a slice: what is sent with delay stands where it is seen. */
    @Test
    void aBrokenInvariantTellsWhatPartsSend() throws Exception {
        write(
                "Chain.arc",
                CHAIN.replace("PROMISE", "").replace("INVARIANT", "inv off: (on == --) || !on;"));
        Story story = firstVerdict();
        assertThat(texts(track(story, "on"))).containsExactly("false", "true");
        assertThat(texts(track(story, "maybe.said"))).containsExactly("true", "-");
        assertThat(texts(track(story, "repeat.o"))).containsExactly("false", "true");
        assertThat(texts(track(story, "maybe"))).containsExactly("loud", "loud");
        assertThat(story.drawings())
                .extracting(Drawing::title)
                .containsExactly("Chain", "maybe", "repeat");
    }

    /** The interpreter sends nothing where all is allowed: it shows no run like this one. */
    @Test
    void nothingIsToldOfPartsWhereNoRunIsFound() throws Exception {
        never();
        String open =
                CHAIN.replace("\"ignore\"", "\"output\"").replace("{i == true}", "{i == false}");
        write("Chain.arc", open.replace("PROMISE", "refines Never").replace("INVARIANT", ""));
        Story story = firstVerdict();
        assertThat(story.timeline().flaws()).hasSize(1);
        assertThat(story.timeline().tracks())
                .extracting(Track::group)
                .noneMatch(group -> group.startsWith(Track.PART));
        assertThat(story.drawings())
                .extracting(Drawing::title)
                .containsExactly("left: Chain", "right: Never");
        assertThat(story.drawings().get(0).carried()).isEmpty();
    }
}
