package arcomat.syntax.build;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import org.junit.jupiter.api.Test;

import java.util.HashMap;
import java.util.Map;

/** Each text is the one that stands in the file, and equal ones are one object. */
class KnownTextsTest {
    /** Two alphabets of two letters that have equal sums: many hashes of strings collide. */
    private static final String LETTERS = "AaBB";

    @Test
    void equalTextsAreOne() {
        StringBuilder letters = new StringBuilder();
        for (int i = 0; i < 2_000; i++) {
            letters.append(LETTERS.charAt(i * i / 7 % LETTERS.length()));
        }
        SourceFile file = new SourceFile("a.arc", letters.toString());
        KnownTexts texts = new KnownTexts(file.text());
        Map<String, String> seen = new HashMap<>();
        for (int start = 0; start < 1_980; start++) {
            Span span = file.span(start, start + 1 + start % 20);
            String text = texts.of(span);
            assertThat(text).isEqualTo(span.text());
            String earlier = seen.putIfAbsent(text, text);
            assertThat(earlier == null || earlier == text).isTrue();
        }
    }
}
