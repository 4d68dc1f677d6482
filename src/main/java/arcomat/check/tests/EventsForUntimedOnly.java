package arcomat.check.tests;

import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.tree.TestSuite;

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
                        keywordSpan(streams),
                        "component '%s' works slice by slice; drive it with an 'input' block",
                        component.name());
            } else if (streams.kind() == TestSuite.Kind.INPUT && eventDriven) {
                findings.report(
                        keywordSpan(streams),
                        "component '%s' is untimed; drive it with an 'events' block",
                        component.name());
            } else if (eventDriven) {
                streams.streams().forEach(stream -> checkTicks(stream, findings));
            }
        }
    }

    private static void checkTicks(TestSuite.PortStream stream, Findings findings) {
        for (TestSuite.StreamElement element : TestSuite.StreamElement.written(stream.elements())) {
            if (element instanceof TestSuite.Tick) {
                findings.report(
                        element,
                        "'Tk' ends a slice, but an untimed component knows none; leave it out");
            }
        }
    }

    /** Where the word stands that a block of streams starts with. */
    private static Span keywordSpan(TestSuite.Streams streams) {
        Span whole = streams.span();
        return whole.file().span(whole.start(), whole.start() + streams.kind().name().length());
    }
}
