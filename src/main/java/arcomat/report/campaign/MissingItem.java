package arcomat.report.campaign;

import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.Coverage;

import java.util.ArrayList;
import java.util.List;

/**
 * Something that no run has covered.
 *
 * @param file of the model
 * @param text the transition as it is written, or {@code state NAME}
 * @param coded whether the program has it: another one may always be taken first
 */
record MissingItem(String file, int line, String text, boolean coded) {
    /** The states, then the transitions, automaton by automaton. */
    static List<MissingItem> of(Coverage coverage) {
        List<MissingItem> missing = new ArrayList<>();
        coverage.automata().forEach(each -> addMissing(each, missing));
        return missing;
    }

    private static void addMissing(Coverage.OfAutomaton covered, List<MissingItem> missing) {
        AutomatonItems items = covered.items();
        for (int i = 0; i < items.states().size(); i++) {
            if (covered.states().get(i) == 0) {
                AutomatonItems.State state = items.states().get(i);
                missing.add(
                        new MissingItem(items.file(), state.line(), "state " + state.name(), true));
            }
        }
        for (int i = 0; i < items.transitions().size(); i++) {
            if (covered.transitions().get(i) == 0) {
                AutomatonItems.Transition each = items.transitions().get(i);
                missing.add(new MissingItem(items.file(), each.line(), each.text(), each.coded()));
            }
        }
    }

    /** {@code FILE:LINE}. */
    String place() {
        return file + ":" + line;
    }
}
