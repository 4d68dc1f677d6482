package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.expressions.VariableSymbol.Kind;

/**
 * ARC0128: a variable beside the automata of a component is a constant that they share: it has a
 * value, and nobody assigns it.
 */
public final class ComponentVariableConstant implements Check.OnVariable, Check.OnItem {

    @Override
    public void check(VariableSymbol variable, Context context, Findings findings) {
        if (variable.kind() == Kind.COMPONENT
                && variable.node().initial().isEmpty()
                && !variable.type().isErroneous()) {
            findings.report(
                    variable.nameSpan(),
                    "'%s' is a constant and needs a value; if it changes, declare it as a"
                            + " 'variable' of the automaton",
                    variable.name());
        }
    }

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        ValueSymbol target = item.target().found().orElse(null);
        if (item.hasName()
                && context.side().orElseThrow() != Side.INPUT
                && target instanceof VariableSymbol variable
                && variable.kind() == Kind.COMPONENT) {
            findings.report(
                            item.node().name().orElseThrow(),
                            "'%s' is a constant of the component and cannot be assigned; declare it"
                                    + " as a 'variable' of the automaton",
                            variable.name())
                    .related(variable.nameSpan(), "the constant");
        }
    }
}
