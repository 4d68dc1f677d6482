package arcomat.check.tests;

import arcomat.source.Span;
import arcomat.tree.TestSuite;

import java.util.List;

/** The parts of a test suite that several checks look at. */
final class Tests {
    private Tests() {}

    static List<TestSuite.Test> of(TestSuite suite) {
        return suite.members().stream()
                .filter(TestSuite.Test.class::isInstance)
                .map(TestSuite.Test.class::cast)
                .toList();
    }

    /** Where the word stands that a block of streams starts with. */
    static Span keywordSpan(TestSuite.Streams streams) {
        Span whole = streams.span();
        return whole.file().span(whole.start(), whole.start() + streams.kind().name().length());
    }
}
