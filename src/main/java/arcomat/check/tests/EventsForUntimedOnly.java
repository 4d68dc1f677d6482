package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.tree.TestSuite;

import java.util.List;

/** ARC0707: events drive untimed components, input streams drive the others. */
public final class EventsForUntimedOnly implements Check.OnStreamTest {

    @Override
    public void check(StreamTestSymbol test, Context context, Findings findings) {
        test.suite()
                .component()
                .found()
                .ifPresent(component -> check(test.node(), component, findings));
    }

    private static void check(TestSuite.Test test, ComponentSymbol component, Findings findings) {
        boolean eventDriven = component.isEventDriven();
        for (TestSuite.Streams streams : test.streams()) {
            if (streams.kind() == TestSuite.Kind.EVENTS && !eventDriven) {
                findings.report(
                        Tests.keywordSpan(streams),
                        "component '%s' works slice by slice; drive it with an 'input' block",
                        component.name());
            } else if (streams.kind() == TestSuite.Kind.INPUT && eventDriven) {
                findings.report(
                        Tests.keywordSpan(streams),
                        "component '%s' is untimed; drive it with an 'events' block",
                        component.name());
            } else if (eventDriven) {
                streams.streams().forEach(stream -> checkTicks(stream.elements(), findings));
            }
        }
    }

    private static void checkTicks(List<TestSuite.StreamElement> elements, Findings findings) {
        for (TestSuite.StreamElement element : elements) {
            if (element instanceof TestSuite.Tick) {
                findings.report(
                        element,
                        "'Tk' ends a slice, but an untimed component knows none; leave it out");
            } else if (element instanceof TestSuite.Repeat repeat) {
                checkTicks(repeat.elements(), findings);
            }
        }
    }
}
