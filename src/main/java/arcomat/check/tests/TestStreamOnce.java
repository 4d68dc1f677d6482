package arcomat.check.tests;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.tree.QualifiedName;
import arcomat.tree.TestSuite;

import java.util.List;

/** ARC0709: a test has at most one input stream, and at most one expected stream, for each port. */
public final class TestStreamOnce implements Check.OnStreamTest {

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        for (TestSuite.Kind kind : List.of(TestSuite.Kind.INPUT, TestSuite.Kind.EXPECT)) {
            Duplicates.report(
                    test.node().streams().stream()
                            .filter(streams -> streams.kind() == kind)
                            .flatMap(streams -> streams.streams().stream())
                            .map(TestSuite.PortStream::port)
                            .toList(),
                    QualifiedName::text,
                    (port, first) ->
                            findings.report(
                                            port,
                                            "test '%s' has two streams for '%s'; join them or"
                                                    + " remove one",
                                            test.name(),
                                            port)
                                    .related(first, "the other one is here"));
        }
    }
}
