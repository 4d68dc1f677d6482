package arcomat.check.behaviour.automaton;

import arcomat.check.behaviour.item.Items;
import arcomat.check.law.Check;
import arcomat.check.naming.InitialDeclaredOnce;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;
import arcomat.tree.Name;

import java.util.List;

/** ARC0303: an automaton that code is generated from starts in exactly one state. */
public final class SingleInitial implements Check.OnAutomaton {

    /** A state that is initial twice is the business of {@link InitialDeclaredOnce}. */
    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        List<InitialSymbol> initials = automaton.initials();
        if (Items.isRequirement(automaton) || initials.isEmpty()) {
            return;
        }
        Name first = initials.get(0).name();
        for (InitialSymbol initial : initials) {
            Name name = initial.name();
            if (!name.text().equals(first.text())) {
                findings.report(
                                name,
                                "generated code starts in one state, and '%s' is initial already;"
                                        + " decide for one of the two",
                                first)
                        .related(first, "also initial");
            }
        }
    }
}
