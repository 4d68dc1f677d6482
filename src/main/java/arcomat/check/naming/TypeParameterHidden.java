package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Component.TypeParameter;
import arcomat.tree.Name;

import java.util.List;
import java.util.Optional;

/** ARC0218: no type parameter has the name of one of a component around it. (Hab16 B1) */
public final class TypeParameterHidden implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        List<Name> names = names(component);
        Optional<ComponentSymbol> around = component.enclosing();
        while (!names.isEmpty() && around.isPresent()) {
            compare(names, around.get(), findings);
            around = around.get().enclosing();
        }
    }

    private static void compare(List<Name> names, ComponentSymbol around, Findings findings) {
        for (Name outer : names(around)) {
            for (Name name : names) {
                if (name.text().equals(outer.text())) {
                    findings.report(
                                    name,
                                    "type parameter '%s' hides the one of '%s' around it; rename"
                                            + " one of them",
                                    name,
                                    around.name())
                            .related(outer, "the one that is hidden");
                }
            }
        }
    }

    private static List<Name> names(ComponentSymbol component) {
        return component.node().typeParameters().stream().map(TypeParameter::name).toList();
    }
}
