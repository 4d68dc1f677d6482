package arcomat.analysis.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.evolution.Change.Relation;
import arcomat.analysis.evolution.Change.Witness;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Explored;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** What comparisons of two versions, promise by promise and both ways, say of the change. */
class ChangeTest {
    private static List<Witness> witnesses(String answers) {
        return Arrays.stream(answers.split(" "))
                .map(answer -> new Witness("left", "right", verdict(answer)))
                .toList();
    }

    private static Verdict verdict(String answer) {
        return switch (answer) {
            case "holds" -> Verdict.holds(Optional.empty(), List.of(), Explored.NOTHING);
            case "fails" -> Verdict.fails("behaviour", List.of());
            default -> Verdict.unknown("too large");
        };
    }

    /** What is not known is never taken to be kept. */
    @ParameterizedTest
    @CsvSource({
        "holds,               holds,         EQUIVALENT,   ''",
        "holds,               fails,         REFINES,      fails",
        "holds,               unknown,       REFINES,      unknown",
        "fails,               holds,         WIDENS,       fails",
        "fails,               fails,         INCOMPARABLE, fails fails",
        "fails,               unknown,       INCOMPARABLE, fails unknown",
        "unknown,             holds,         UNKNOWN,      ''",
        "unknown,             fails,         UNKNOWN,      ''",
        "holds unknown,       holds,         UNKNOWN,      ''",
        "holds unknown fails, holds,         WIDENS,       fails",
        "holds holds,         holds unknown, REFINES,      unknown"
    })
    void bothWaysTogether(String forward, String backward, Relation relation, String shown) {
        Change change = Change.of(witnesses(forward), witnesses(backward));
        assertThat(change.relation()).isEqualTo(relation);
        assertThat(change.reason()).isEqualTo(relation == Relation.UNKNOWN ? "too large" : "");
        assertThat(change.witnesses())
                .extracting(witness -> witness.verdict().answer().name().toLowerCase(Locale.ROOT))
                .isEqualTo(shown.isEmpty() ? List.of() : List.of(shown.split(" ")));
    }

    @ParameterizedTest
    @CsvSource({
        "UNCHANGED, false, false",
        "EQUIVALENT, false, false",
        "REFINES, false, false",
        "WIDENS, true, true",
        "INCOMPARABLE, true, true",
        "NEW, false, false",
        "GONE, true, true",
        "UNKNOWN, false, true"
    })
    void whatIsGoneOrLessIsBroken(Relation relation, boolean breaks, boolean doubtful) {
        assertThat(relation.breaks()).isEqualTo(breaks);
        assertThat(relation.isDoubtful()).isEqualTo(doubtful);
    }

    /** A reason excuses what is not kept, and what is not known to be. */
    @ParameterizedTest
    @CsvSource({
        "UNCHANGED, HOLDS, HOLDS",
        "EQUIVALENT, HOLDS, HOLDS",
        "REFINES, HOLDS, HOLDS",
        "WIDENS, FAILS, HOLDS",
        "INCOMPARABLE, FAILS, HOLDS",
        "NEW, HOLDS, HOLDS",
        "GONE, FAILS, HOLDS",
        "UNKNOWN, UNKNOWN, HOLDS"
    })
    void theGateIsShutWithoutAReason(Relation relation, Answer alone, Answer excused) {
        Change change = new Change(relation, List.of(), "");
        assertThat(entry(change, Optional.empty()).answer()).isEqualTo(alone);
        assertThat(entry(change, Optional.of("wanted")).answer()).isEqualTo(excused);
        Gate.Entry fine = entry(Change.UNCHANGED, Optional.empty());
        Gate.Entry bad = entry(change, Optional.empty());
        assertThat(new Gate(List.of(fine, bad, fine)).answer()).isEqualTo(alone);
        assertThat(new Gate(List.of()).answer()).isEqualTo(Answer.HOLDS);
    }

    @Test
    void whatIsOwedToAPartIsOwedToWhatThatIsOwedTo() {
        Gate.Entry part = entry(Change.GONE, Optional.of("wanted"));
        Gate.Entry whole = entry(Change.GONE, Optional.empty()).owedTo(part);
        assertThat(whole.excuse()).contains("wanted");
        assertThat(whole.cause()).contains("p.Part");
        assertThat(entry(Change.GONE, Optional.empty()).owedTo(whole).cause()).contains("p.Part");
    }

    private static Gate.Entry entry(Change change, Optional<String> excuse) {
        return new Gate.Entry(
                "p.Part", change, Optional.empty(), Optional.empty(), excuse, Optional.empty());
    }

    /** What is asked for where all has to hold. */
    @ParameterizedTest
    @CsvSource({
        "HOLDS, HOLDS, HOLDS",
        "HOLDS, UNKNOWN, UNKNOWN",
        "HOLDS, FAILS, FAILS",
        "UNKNOWN, UNKNOWN, UNKNOWN",
        "UNKNOWN, FAILS, FAILS",
        "FAILS, FAILS, FAILS"
    })
    void theWorstAnswerCounts(Answer one, Answer other, Answer both) {
        assertThat(one.and(other)).isEqualTo(both);
        assertThat(other.and(one)).isEqualTo(both);
    }
}
