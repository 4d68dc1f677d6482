package arcomat.check.walk;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Check.Context;
import arcomat.check.law.Suppressions;
import arcomat.check.walk.Listeners.Listener;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;

import java.util.List;

/** The part of the walk that looks at stereotypes, and notes what they suppress. */
record StereotypeWalk(Listeners listeners, Suppressions suppressions) {

    void visit(List<Stereotype> stereotypes, Carrier carrier, Node owner, Context context) {
        if (stereotypes.isEmpty()) {
            return;
        }
        suppressions.add(stereotypes, owner);
        for (Stereotype each : stereotypes) {
            for (Listener<Check.OnStereotype> listener : listeners.onStereotype) {
                listener.check().check(each, carrier, context, listener.findings());
            }
        }
    }
}
