package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.tree.TestSuite;

import java.util.Optional;

/** ARC0706: a stream of a component that works slice by slice has one message in a slice. */
public final class TestSingleMessagePerSlice implements Check.OnTestSuite {

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        Optional<ComponentSymbol> component = suite.component().found();
        if (component.isEmpty() || component.get().isEventDriven()) {
            return;
        }
        for (StreamTestSymbol test : suite.tests()) {
            for (TestSuite.Streams streams : test.node().streams()) {
                if (streams.kind() != TestSuite.Kind.EVENTS) {
                    streams.streams().forEach(stream -> check(stream, findings));
                }
            }
        }
    }

    private static void check(TestSuite.PortStream stream, Findings findings) {
        StreamSlices.read(
                stream.elements(),
                message ->
                        findings.report(
                                message.expression(),
                                "this slice of '%s' has a message already; write 'Tk' between two"
                                        + " messages",
                                stream.port()));
    }
}
