package arcomat.check.tests;

import arcomat.source.Span;
import arcomat.tree.TestSuite;

import java.util.List;
import java.util.Locale;

/** The parts of a test suite that several checks look at. */
final class Tests {
    private Tests() {}

    static List<TestSuite.Test> of(TestSuite suite) {
        return suite.members().stream()
                .filter(TestSuite.Test.class::isInstance)
                .map(TestSuite.Test.class::cast)
                .toList();
    }

    /** The word that a block of streams starts with. */
    static String keyword(TestSuite.Kind kind) {
        return kind.name().toLowerCase(Locale.ROOT);
    }

    /** Where that word stands. */
    static Span keywordSpan(TestSuite.Streams streams) {
        Span whole = streams.span();
        return whole.file().span(whole.start(), whole.start() + keyword(streams.kind()).length());
    }
}
