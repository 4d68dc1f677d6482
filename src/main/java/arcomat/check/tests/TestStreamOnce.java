package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.tree.QualifiedName;
import arcomat.tree.TestSuite;

import java.util.EnumMap;
import java.util.HashMap;
import java.util.Map;

/** ARC0709: a test has at most one input stream, and at most one expected stream, for each port. */
public final class TestStreamOnce implements Check.OnTestSuite {

    @Override
    public Law law() {
        return Law.error("ARC0709");
    }

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        for (TestSuite.Test test : Tests.of(suite.node())) {
            check(test, findings);
        }
    }

    private static void check(TestSuite.Test test, Findings findings) {
        Map<TestSuite.Kind, Map<String, QualifiedName>> seen = new EnumMap<>(TestSuite.Kind.class);
        for (TestSuite.Streams streams : test.streams()) {
            if (streams.kind() == TestSuite.Kind.EVENTS) {
                continue;
            }
            for (TestSuite.PortStream stream : streams.streams()) {
                QualifiedName first =
                        seen.computeIfAbsent(streams.kind(), kind -> new HashMap<>())
                                .putIfAbsent(stream.port().text(), stream.port());
                if (first != null) {
                    report(test, stream.port(), first, findings);
                }
            }
        }
    }

    private static void report(
            TestSuite.Test test, QualifiedName port, QualifiedName first, Findings findings) {
        findings.report(
                        port,
                        "test '"
                                + test.name()
                                + "' has two streams for '"
                                + port
                                + "'; join them or remove one")
                .related(first, "the other one is here");
    }
}
