package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.StreamExtent;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.StreamTestSymbol.StreamSymbol;
import arcomat.tree.TestSuite;

import java.util.Comparator;

/** ARC0710: repetitions stay within what can be run: some, and not too many. */
public final class TestStreamLength implements Check.OnStreamTest {

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        for (StreamSymbol stream : test.streams()) {
            TestSuite.StreamElement.written(stream.node().elements())
                    .forEach(element -> checkCount(element, findings));
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

    private static void checkCount(TestSuite.StreamElement element, Findings findings) {
        if (element instanceof TestSuite.Repeat repeat && repeat.count() < 1) {
            findings.report(
                    repeat,
                    "this repeats %s times; repeat at least once, or remove it",
                    repeat.count());
        }
    }
}
