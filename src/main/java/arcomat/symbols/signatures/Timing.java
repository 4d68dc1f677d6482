package arcomat.symbols.signatures;

import arcomat.tree.Component;
import arcomat.tree.Element;

import java.util.List;
import java.util.Optional;

/**
 * How time passes in a component.
 *
 * @param node the first timing of the component; empty for the default
 * @param eventDriven whether it steps once per event ({@code untimed})
 * @param delay of outputs that say nothing themselves
 */
public record Timing(Optional<Element.Timing> node, boolean eventDriven, int delay) {
    public static final Timing DEFAULT = new Timing(Optional.empty(), false, 1);

    static Timing of(Component component) {
        List<Element.Timing> written = component.elements(Element.Timing.class);
        return written.isEmpty() ? DEFAULT : of(written.get(0));
    }

    private static Timing of(Element.Timing node) {
        Optional<Element.Timing> place = Optional.of(node);
        return switch (node.kind()) {
            case INSTANT, SYNC -> new Timing(place, false, 0);
            // Nothing but the delay of what others see: no behaviour has this time here.
            case DELAYED, CAUSALSYNC, TIMED -> new Timing(place, false, 1);
            case UNTIMED -> new Timing(place, true, 0);
        };
    }

    boolean isWritten() {
        return node.isPresent();
    }
}
