package arcomat.report.finding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.finding.Baseline.Comparison;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

class BaselineTest {
    private static final UnaryOperator<String> SAME = UnaryOperator.identity();

    private static Diagnostic finding(String text, String word) {
        return finding(text, word, 0);
    }

    private static Diagnostic finding(String text, String word, int from) {
        int start = text.indexOf(word, from);
        SourceFile file = new SourceFile("a.arc", text);
        return Diagnostic.error("ARC0104", file.span(start, start + word.length()), "no");
    }

    private static Comparison compare(List<Diagnostic> before, List<Diagnostic> after) {
        return Baseline.of(before, SAME).compare(after, SAME);
    }

    @Test
    void movedAndReformattedPlacesAreKnown() {
        Diagnostic before = finding("connect a -> b;", "connect a -> b;");
        Diagnostic after = finding("\n\n  connect a  ->  b; // so", "connect a  ->  b;");
        assertThat(compare(List.of(before), List.of(after)).known()).containsExactly(after);
    }

    @Test
    void ofPlacesAlikeAsManyAreKnownAsThereWere() {
        String text = "o o o";
        Diagnostic first = finding(text, "o");
        Diagnostic second = finding(text, "o", 2);
        Comparison comparison = compare(List.of(first), List.of(first, second));
        assertThat(comparison.known()).containsExactly(first);
        assertThat(comparison.fresh()).containsExactly(second);
        Comparison less = compare(List.of(first, second), List.of(second));
        assertThat(less.gone().values()).containsExactly(1);
    }

    @Test
    void anotherTextOrCodeIsNew() {
        Diagnostic before = finding("a b", "a");
        assertThat(compare(List.of(before), List.of(finding("a b", "b"))).fresh()).hasSize(1);
        Diagnostic other = Diagnostic.error("ARC0105", before.span(), "no");
        assertThat(compare(List.of(before), List.of(other)).fresh()).containsExactly(other);
    }

    @Property
    void whatIsWrittenIsReadAgain(@ForAll @Size(max = 5) List<String> paths) throws Exception {
        List<Diagnostic> findings = new ArrayList<>();
        for (String path : paths) {
            if (!path.isEmpty()) {
                SourceFile file = new SourceFile(path, "text");
                findings.add(Diagnostic.error("ARC0104", file.span(0, 4), "no"));
            }
        }
        Baseline baseline = Baseline.of(findings, SAME);
        assertThat(BaselineText.parse(BaselineText.render(baseline))).isEqualTo(baseline);
    }
}
