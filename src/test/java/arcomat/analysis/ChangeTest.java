package arcomat.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Change.Relation;
import arcomat.analysis.Change.Witness;
import arcomat.analysis.Verdict.Answer;
import arcomat.analysis.Verdict.Explored;

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
