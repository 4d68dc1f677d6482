package arcomat.check;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.util.List;

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

    @Test
    void findingsAreOrderedAndUnique() {
        List<Diagnostic> findings = Checking.review(List.of(MEANT), Profile.EXECUTABLE).findings();
        assertThat(findings).isSortedAccordingTo(Diagnostic.ORDER).doesNotHaveDuplicates();
    }
}
