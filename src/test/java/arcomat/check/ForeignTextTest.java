package arcomat.check;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.law.Profile;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.util.List;

/** What is told about texts in other languages than automata: the tables, here. */
class ForeignTextTest {
    private static final String TABLE =
            """
            component Lamp {
              port in Boolean push, out Boolean lit;

              table {
                in %s;
                out lit;
                | %s | => | true |;
              }
            }
            """;

    private static List<Diagnostic> findings(String column, String cell) {
        SourceFile file = new SourceFile("Lamp.arc", TABLE.formatted(column, cell));
        return Checking.review(List.of(file), Profile.REQUIREMENTS).findings();
    }

    @Test
    void aRepairInWhatWasTakenOverIsKept() {
        Diagnostic finding = findings("push", "pusch").get(0);
        assertThat(finding.span().text()).isEqualTo("pusch");
        assertThat(finding.fix().orElseThrow().edits())
                .singleElement()
                .satisfies(
                        edit -> {
                            assertThat(edit.span()).isEqualTo(finding.span());
                            assertThat(edit.text()).isEqualTo("push");
                        });
    }

    @Test
    void aRepairOfTheLanguageIsItsOwn() {
        Diagnostic finding = findings("pusch", "true").get(0);
        assertThat(finding.code()).isEqualTo("ARC0334");
        assertThat(finding.fix().orElseThrow().edits().get(0).text()).isEqualTo("push");
    }

    @Test
    void aLawIsToldWithTheCodeOfTheLanguage() {
        assertThat(findings("push", "3"))
                .extracting(Diagnostic::code)
                .contains("ARC0336")
                .doesNotContain("ARC0316");
    }
}
