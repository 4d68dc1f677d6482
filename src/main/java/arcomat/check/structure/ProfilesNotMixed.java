package arcomat.check.structure;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.Profiles;

import java.util.Optional;

/**
 * ARC0129: the components of a network are all time-synchronous or all event-driven. A decomposed
 * component is what its parts are; platform components adapt to what they are connected with.
 */
public final class ProfilesNotMixed implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0129").needing(Law.Needs.ALL);
    }

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
                        "'"
                                + instance.name()
                                + "' is "
                                + words(eventDriven)
                                + ", but '"
                                + first.name()
                                + "' is "
                                + words(!eventDriven)
                                + "; give all parts the same kind of timing")
                .related(first.nameSpan(), "'" + first.name() + "' is " + words(!eventDriven));
    }

    private static void compareWithOwnTiming(
            ComponentSymbol component, InstanceSymbol first, Findings findings) {
        boolean own = component.signature().timing().eventDriven();
        boolean parts = isEventDriven(first).orElseThrow();
        if (component.signature().timing().node().isPresent() && own != parts) {
            findings.report(
                    component.signature().timing().node().get(),
                    "'"
                            + component.name()
                            + "' is declared to be "
                            + words(own)
                            + ", but its part '"
                            + first.name()
                            + "' is "
                            + words(parts)
                            + "; delete this clause or change the parts");
        }
    }

    private static String words(boolean eventDriven) {
        return eventDriven ? "event-driven" : "time-synchronous";
    }

    private static Optional<Boolean> isEventDriven(InstanceSymbol instance) {
        return instance.component().flatMap(Profiles::eventDriven);
    }
}
