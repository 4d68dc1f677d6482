package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Component.TypeParameter;
import arcomat.tree.Name;

/** ARC0209: names of components and message types start with a capital letter. (Hab16 CV1) */
public final class TypeNameCapitalised implements Check.OnComponent, Check.OnClassDiagram {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        check("component", component.node().name(), findings);
        for (TypeParameter parameter : component.node().typeParameters()) {
            check("type parameter", parameter.name(), findings);
        }
    }

    @Override
    public void check(DiagramSymbol diagram, Context context, Findings findings) {
        for (ClassDiagram.TypeDefinition type : diagram.node().types()) {
            check("type", type.name(), findings);
        }
    }

    private static void check(String kind, Name name, Findings findings) {
        if (Character.isLowerCase(name.text().charAt(0))) {
            findings.report(
                    name, "%s '%s' should start with a capital letter; rename it", kind, name);
        }
    }
}
