package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.StreamExtent;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.StreamTestSymbol.StreamSymbol;
import arcomat.tree.TestSuite;

import java.util.Comparator;
import java.util.List;

/** ARC0710: repetitions stay within what can be run: some, and not too many. */
public final class TestStreamLength implements Check.OnStreamTest {

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        for (StreamSymbol stream : test.streams()) {
            checkCounts(stream.node().elements(), findings);
        }
        if (test.isTooLong()) {
            test.streams().stream()
                    .max(Comparator.comparingLong(stream -> stream.extent().total()))
                    .ifPresent(longest -> reportLength(longest, findings));
        }
    }

    private static void reportLength(StreamSymbol longest, Findings findings) {
        findings.report(
                longest.node().port(),
                "the streams of this test have more than %,d slices and messages, most of them"
                        + " here; repeat fewer times",
                StreamExtent.LIMIT);
    }

    private static void checkCounts(List<TestSuite.StreamElement> elements, Findings findings) {
        for (TestSuite.StreamElement element : elements) {
            if (element instanceof TestSuite.Repeat repeat) {
                if (repeat.count() < 1) {
                    findings.report(
                            repeat,
                            "this repeats %s times; repeat at least once, or remove it",
                            repeat.count());
                }
                checkCounts(repeat.elements(), findings);
            }
        }
    }
}
