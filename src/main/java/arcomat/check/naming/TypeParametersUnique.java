package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Name;
import arcomat.tree.TypeParameter;

import java.util.HashMap;
import java.util.Map;

/** ARC0202: the type parameters of a component differ in name. */
public final class TypeParametersUnique implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0202");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (TypeParameter parameter : component.node().typeParameters()) {
            Name first = seen.putIfAbsent(parameter.name().text(), parameter.name());
            if (first != null) {
                findings.report(
                                parameter.name(),
                                "component '"
                                        + component.name()
                                        + "' has a type parameter '"
                                        + first
                                        + "' already; rename one of them")
                        .related(first, "the first one");
            }
        }
    }
}
