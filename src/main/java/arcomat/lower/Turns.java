package arcomat.lower;

import arcomat.model.Expression;
import arcomat.tree.AutomatonElement;

import java.util.ArrayList;
import java.util.List;

/**
 * The transitions of an automaton whose turn has come, in the order of the text. A later one denies
 * what the earlier ones ask for, save those that can never be satisfied together with it.
 */
final class Turns {
    private record Turn(AutomatonElement.Transition transition, TransitionCondition demand) {}

    private final List<Turn> earlier = new ArrayList<>();

    /** What has to be true of one besides what it asks for. Each is to be shown once. */
    List<Expression> denials(AutomatonElement.Transition transition, TransitionCondition demand) {
        List<Expression> denials = new ArrayList<>();
        for (Turn each : earlier) {
            if (precedes(each.transition(), transition) && demand.canMeet(each.demand())) {
                denials.add(each.demand().denial(transition.span()));
            }
        }
        earlier.add(new Turn(transition, demand));
        return denials;
    }

    private static boolean precedes(
            AutomatonElement.Transition first, AutomatonElement.Transition second) {
        return first.turn() < second.turn() && first.source().text().equals(second.source().text());
    }
}
