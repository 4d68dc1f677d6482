package arcomat.check;

import arcomat.tree.ClassDiagram;
import arcomat.tree.Component;
import arcomat.tree.Name;
import arcomat.tree.TypeParameter;

/** ARC0209: names of components and message types start with a capital letter. (Hab16 CV1) */
final class TypeNameCapitalised implements Check.OnComponent, Check.OnClassDiagram {

    @Override
    public Law law() {
        return Law.warning("ARC0209");
    }

    @Override
    public void check(Component component, Context context, Findings findings) {
        check("component", component.name(), findings);
        for (TypeParameter parameter : component.typeParameters()) {
            check("type parameter", parameter.name(), findings);
        }
    }

    @Override
    public void check(ClassDiagram diagram, Context context, Findings findings) {
        for (ClassDiagram.TypeDefinition type : diagram.types()) {
            check("type", type.name(), findings);
        }
    }

    private static void check(String kind, Name name, Findings findings) {
        if (Character.isLowerCase(name.text().charAt(0))) {
            findings.report(
                    name, kind + " '" + name + "' should start with a capital letter; rename it");
        }
    }
}
