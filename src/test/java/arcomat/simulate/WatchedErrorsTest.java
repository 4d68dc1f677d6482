package arcomat.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Model;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.simulate.watch.Watch;
import arcomat.simulate.watch.Watch.Violation;
import arcomat.simulate.watch.Watching;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a requirement that goes wrong, or forbids an input, allows: slice by slice, word by word.
 */
class WatchedErrorsTest {
    private static final Model MODEL =
            Lowering.lower(
                    Scenario.read(Path.of("src/test/resources/monitors/errors.txt")).workspace());
    private static final Letter SILENCE = Letter.SILENCE;
    private static final Letter ONE = letter("x", 1);
    private static final Letter SENT = letter("y", 1);

    private static Letter letter(String port, int value) {
        return Letter.of(Map.of(port, new Value.IntegerValue(value)));
    }

    private static Component component(String name) {
        return MODEL.component("p." + name).orElseThrow();
    }

    /** The first word about inputs and outputs, one after the other. */
    private static String word(String name, Optional<Trace.End> end, Letter... letters) {
        Component component = component(name);
        List<Trace.Step> steps = new ArrayList<>();
        for (int i = 0; i < letters.length; i += 2) {
            steps.add(new Trace.Step(i / 2, letters[i], letters[i + 1], List.of()));
        }
        Trace run = new Trace(component, steps, Optional.empty(), Optional.empty(), end);
        Watch watch = new Watch(component, component.automata().get(0), List.of());
        return Watching.all(List.of(watch), run)
                .get(0)
                .violation()
                .map(Violation::message)
                .orElse("");
    }

    private static Optional<Trace.End> end(Letter input, Letter shown) {
        return Optional.of(new Trace.End(input, shown));
    }

    @Test
    void aTransitionThatGoesWrongForbidsNoOther() {
        assertThat(word("Either", Optional.empty(), ONE, SILENCE, SILENCE, SENT)).isEmpty();
        assertThat(word("Either", end(ONE, SILENCE))).isEmpty();
        assertThat(word("Either", Optional.empty(), ONE, SILENCE, SILENCE, SILENCE))
                .isEqualTo(
                        "slice 1: p.Either (line 5) forbids y = --; it allows y = 1 (line 9: s ->"
                                + " s)");
    }

    /** With delay 1, whoever goes on is seen to do so in the next slice. */
    @Test
    void aForbiddenInputAllowsOnlyTheEnd() {
        String only = "p.Late (line 5) allows only an error in slice 0: it forbids this input in s";
        assertThat(word("Late", Optional.empty(), ONE, SILENCE)).isEmpty();
        assertThat(word("Late", Optional.empty(), ONE, SILENCE, SILENCE, SILENCE))
                .isEqualTo("slice 1: " + only);
        assertThat(word("Late", end(SILENCE, SILENCE), ONE, SILENCE)).isEqualTo("slice 1: " + only);
        assertThat(word("Late", end(ONE, SILENCE))).isEmpty();
        assertThat(word("Late", end(SILENCE, SILENCE)))
                .isEqualTo("slice 0: p.Late (line 5) forbids that the run ends in an error");
    }

    /** Without delay, in the same one; and an end shows nothing. */
    @Test
    void anInstantRequirementSaysSoAtOnce() {
        String instant = "slice 0: p.Instant (line 6) ";
        assertThat(word("Instant", Optional.empty(), ONE, SILENCE))
                .isEqualTo(instant + "allows only an error in slice 0: it forbids this input in s");
        assertThat(word("Instant", end(ONE, SILENCE))).isEmpty();
        assertThat(word("Instant", end(ONE, SENT)))
                .isEqualTo(instant + "forbids y = 1 in the slice of an error");
        assertThat(word("Instant", end(SILENCE, SENT)))
                .isEqualTo(instant + "forbids that the run ends in an error");
    }

    @Test
    void whatWasSentBeforeIsStillSeen() {
        assertThat(word("Shown", end(ONE, SENT))).isEmpty();
        assertThat(word("Shown", end(ONE, SILENCE)))
                .isEqualTo(
                        "slice 0: p.Shown (line 5) forbids y = --; it allows y = 1 (line 7:"
                                + " initial s)");
    }

    @Test
    void chaosAllowsNoError() {
        assertThat(word("Chaos", Optional.empty(), ONE, SILENCE, ONE, SENT)).isEmpty();
        assertThat(word("Chaos", end(ONE, SENT), ONE, SILENCE))
                .isEqualTo("slice 1: p.Chaos (line 5) forbids that the run ends in an error");
    }
}
