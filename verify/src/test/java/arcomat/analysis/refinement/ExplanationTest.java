package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.model.Model;

import org.junit.jupiter.api.Test;

import java.io.IOException;

/** What is said about a failure where both sides err, and one of them has shown more. */
class ExplanationTest {
    @Test
    void anErrorIsNotAlwaysTheSame() throws IOException {
        Model model = Sections.read(VerdictsTest.FOLDER.resolve("visible.txt")).model();
        Verdict verdict =
                Refinement.check(
                        VerdictsTest.promise(model, "v.LateErr", '-'),
                        VerdictsTest.promise(model, "v.SameErr", '-'),
                        Budget.ofMemory());
        assertThat(verdict.explanation())
                .extracting(Sentence::text)
                .anyMatch(text -> text.contains("ends in an error in a slice that still shows"))
                .anyMatch(
                        text ->
                                text.contains(
                                        "allows only an error in a slice that shows nothing"));
    }
}
