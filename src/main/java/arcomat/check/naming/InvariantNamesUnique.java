package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InvariantSymbol;

/** ARC0216: the invariants of a component differ in name. */
public final class InvariantNamesUnique implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Duplicates.report(
                component.ownInvariants(),
                InvariantSymbol::name,
                (invariant, first) ->
                        findings.report(
                                        invariant.node().name(),
                                        "component '%s' has an invariant '%s' already, so that"
                                                + " this one is told as '%s'; rename one of them",
                                        component.name(),
                                        invariant.name(),
                                        invariant.title())
                                .related(first.node().name(), "the first one"));
    }
}
