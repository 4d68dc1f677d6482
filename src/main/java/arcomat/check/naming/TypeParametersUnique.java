package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Component.TypeParameter;

/** ARC0202: the type parameters of a component differ in name. */
public final class TypeParametersUnique implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Duplicates.report(
                component.node().typeParameters().stream().map(TypeParameter::name).toList(),
                findings,
                "component '%s' has a type parameter '%s' already; rename one of them",
                component.name(),
                "the first one");
    }
}
