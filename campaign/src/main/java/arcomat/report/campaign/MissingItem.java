package arcomat.report.campaign;

import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.Coverage;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;

/**
 * Something that no run has covered.
 *
 * @param file of the model
 * @param text the transition as it is written, or {@code state NAME}
 */
record MissingItem(String file, int line, String text) {
    /** What no part has: the states, then the transitions, automaton by automaton. */
    static List<MissingItem> of(Coverage coverage) {
        List<MissingItem> missing = new ArrayList<>();
        for (Coverage.OfAutomaton each : coverage.automata()) {
            add(
                    each.items(),
                    i -> each.states().get(i) == 0,
                    i -> each.transitions().get(i) == 0,
                    missing);
        }
        return missing;
    }

    /** What a part has not, and another part of the same component has. */
    static List<MissingItem> of(Coverage.OfPart part, Coverage.OfAutomaton all) {
        List<MissingItem> missing = new ArrayList<>();
        add(
                all.items(),
                i -> part.states().get(i) == 0 && all.states().get(i) > 0,
                i -> part.transitions().get(i) == 0 && all.transitions().get(i) > 0,
                missing);
        return missing;
    }

    private static void add(
            AutomatonItems items,
            IntPredicate isStateMissing,
            IntPredicate isTransitionMissing,
            List<MissingItem> missing) {
        for (int i = 0; i < items.states().size(); i++) {
            if (isStateMissing.test(i)) {
                AutomatonItems.State state = items.states().get(i);
                missing.add(new MissingItem(items.file(), state.line(), "state " + state.name()));
            }
        }
        for (int i = 0; i < items.transitions().size(); i++) {
            if (isTransitionMissing.test(i)) {
                AutomatonItems.Transition each = items.transitions().get(i);
                missing.add(new MissingItem(items.file(), each.line(), each.text()));
            }
        }
    }

    /** {@code FILE:LINE}. */
    String place() {
        return file + ":" + line;
    }
}
