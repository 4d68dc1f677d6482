package arcomat.check.behaviour.item;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.expressions.VariableSymbol;

/** ARC0317: an initial value has the type of its variable. (RRW14a T2) */
public final class InitialValueFits implements Check.OnVariable {

    @Override
    public void check(VariableSymbol variable, Context context, Findings findings) {
        variable.initial()
                .filter(initial -> !initial.isAssignableTo(variable.type()))
                .ifPresent(
                        initial ->
                                findings.report(
                                        initial.expression().node(),
                                        "%s takes %s",
                                        Items.words(variable),
                                        Wording.mismatch(variable.type(), initial)));
    }
}
