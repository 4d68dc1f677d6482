package arcomat.check;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.law.Profile;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.stream.IntStream;

class ReviewTest {
    private static final SourceFile MEANT =
            new SourceFile(
                    "Meant.arc",
                    """
                    <<platform, layer = "sensors">> component Meant {
                      <<suppress = "ARC0104: both senders agree">> component Inner inner {
                        port in Integer i, in Integer j, <<suppress = "ARC0210: old">> out Integer Out;
                        connect i -> Out;
                        connect j -> Out;
                      }
                    }
                    """);

    @Test
    void whatIsMeantIsKeptWithItsReason() {
        Review review = Checking.review(List.of(MEANT), Profile.REQUIREMENTS);
        assertThat(review.suppressed())
                .extracting(s -> s.finding().code() + ": " + s.reason())
                .containsExactly("ARC0210: old", "ARC0104: both senders agree");
        assertThat(review.findings())
                .extracting(Diagnostic::code)
                .doesNotContain("ARC0104", "ARC0210");
    }

    @Test
    void noCodeIsMadeFromErrorsThatAreMeant() {
        Review review = Checking.review(List.of(MEANT), Profile.EXECUTABLE);
        assertThat(review.findings()).extracting(Diagnostic::code).contains("ARC0104");
        assertThat(review.suppressed())
                .extracting(s -> s.finding().code())
                .containsExactly("ARC0210");
    }

    /** So many that several threads share the walk. */
    @Test
    void noDefinitionIsLostAmongMany() {
        List<SourceFile> many =
                IntStream.range(1000, 2000)
                        .mapToObj(
                                i ->
                                        new SourceFile(
                                                "Meant" + i + ".arc",
                                                MEANT.text().replace("Meant ", "Meant" + i + " ")))
                        .toList();
        Review review = Checking.review(many, Profile.REQUIREMENTS);
        Review one = Checking.review(many.subList(0, 1), Profile.REQUIREMENTS);
        assertThat(review.suppressed()).hasSize(2 * many.size());
        assertThat(review.findings())
                .hasSize(one.findings().size() * many.size())
                .isSortedAccordingTo(Diagnostic.ORDER);
    }

    @Test
    void findingsAreOrderedAndUnique() {
        List<Diagnostic> findings = Checking.review(List.of(MEANT), Profile.EXECUTABLE).findings();
        assertThat(findings).isSortedAccordingTo(Diagnostic.ORDER).doesNotHaveDuplicates();
    }
}
