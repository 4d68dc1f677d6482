package arcomat.report;

import static arcomat.report.ShownTracks.elements;
import static arcomat.report.ShownTracks.texts;
import static arcomat.report.ShownTracks.track;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Answered;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.VerifyPromises;
import arcomat.report.page.Story;
import arcomat.report.page.Story.Drawing;
import arcomat.report.page.Timeline.Flaw;
import arcomat.report.page.Track;
import arcomat.report.verdict.VerdictPage;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** What pages tell about verdicts, before a browser shows it. */
class VerdictPagesTest {
    @TempDir private Path folder;

    private void write(String file, String text) throws IOException {
        Files.writeString(folder.resolve(file), text);
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

    @Test
    void whatHoldsNamesTheCommandThatWritesDownWhy() throws Exception {
        write(
                "Door.arc",
                DoorModel.DOOR.replace("<<completion", "inv closes: left < 3; <<completion"));
        assertThat(firstVerdict().facts())
                .anyMatch(fact -> fact.text().startsWith("'arcomat verify --certificate FILE'"));
        Files.delete(folder.resolve("Door.arc"));
        write("House.arc", DoorModel.DOOR.replace("Door", "House"));
        write(
                "Door.arc",
                DoorModel.DOOR.replace("component Door {", "component Door refines House {"));
        assertThat(firstVerdict().facts())
                .anyMatch(fact -> fact.text().startsWith("'arcomat refines --certificate FILE'"));
    }

    @Test
    void aCounterexampleGoesThroughBothAutomata() throws Exception {
        write("Door.arc", DoorModel.DOOR);
        write(
                "Late.arc",
                DoorModel.DOOR
                        .replace("component Door", "component Late refines Door")
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
