package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.search.Budget;
import arcomat.model.Model;

import org.junit.jupiter.api.Test;

/** Verdicts of MONA's without the program. */
class MonaRefinementTest {
    private static final Model MODEL =
            Sections.read(VerdictsTest.FOLDER.resolve("shapes.txt")).model();

    private static MonaRefinement asked(String left, String right) {
        return MonaRefinement.of(
                VerdictsTest.promise(MODEL, left, '-'),
                VerdictsTest.promise(MODEL, right, '-'),
                Budget.ofMemory());
    }

    @Test
    void countsTheStatesThatWereSpelledOut() {
        MonaRefinement question = asked("n.Early", "n.Four");
        Verdict holds = question.holds();
        assertThat(holds.answer()).isEqualTo(Answer.HOLDS);
        assertThat(holds.notes()).singleElement().asString().startsWith("decided by MONA");
        assertThat(holds.explored()).isEqualTo(new Explored(0, 3, 4));
        Verdict unknown = question.unknown("no answer");
        assertThat(unknown.reason()).isEqualTo("no answer");
        assertThat(unknown.explored()).isEqualTo(new Explored(0, 3, 4));
    }

    @Test
    void isNotAskedWhereInterfacesDiffer() {
        MonaRefinement question = asked("n.Tür", "n.Tor");
        assertThat(question.question()).isEmpty();
        assertThat(question.settled()).map(Verdict::reason).contains("interface");
    }
}
