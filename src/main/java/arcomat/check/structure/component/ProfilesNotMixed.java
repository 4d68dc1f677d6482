package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.Parts;

import java.util.Optional;

/**
 * ARC0129: the components of a network are all time-synchronous or all event-driven. A decomposed
 * component is what its parts are; platform components adapt to what they are connected with.
 */
public final class ProfilesNotMixed implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        InstanceSymbol first = null;
        for (InstanceSymbol instance : component.instances()) {
            Optional<Boolean> eventDriven = isEventDriven(instance);
            if (eventDriven.isEmpty()) {
                continue;
            }
            if (first == null) {
                first = instance;
            } else if (!eventDriven.equals(isEventDriven(first))) {
                report(instance, first, eventDriven.get(), findings);
                return;
            }
        }
        if (first != null) {
            compareWithOwnTiming(component, first, findings);
        }
    }

    private static void report(
            InstanceSymbol instance, InstanceSymbol first, boolean eventDriven, Findings findings) {
        findings.report(
                        instance.nameSpan(),
                        "'%s' is %s, but '%s' is %s; give all parts the same kind of timing",
                        instance.name(),
                        words(eventDriven),
                        first.name(),
                        words(!eventDriven))
                .related(first.nameSpan(), "'" + first.name() + "' is " + words(!eventDriven));
    }

    private static void compareWithOwnTiming(
            ComponentSymbol component, InstanceSymbol first, Findings findings) {
        boolean own = component.signature().timing().eventDriven();
        boolean parts = isEventDriven(first).orElseThrow();
        if (component.signature().timing().node().isPresent() && own != parts) {
            findings.report(
                    component.signature().timing().node().get(),
                    "'%s' is declared to be %s, but its part '%s' is %s; delete this clause or"
                            + " change the parts",
                    component.name(),
                    words(own),
                    first.name(),
                    words(parts));
        }
    }

    private static String words(boolean eventDriven) {
        return eventDriven ? "event-driven" : "time-synchronous";
    }

    private static Optional<Boolean> isEventDriven(InstanceSymbol instance) {
        return instance.component().flatMap(Parts::eventDriven);
    }
}
