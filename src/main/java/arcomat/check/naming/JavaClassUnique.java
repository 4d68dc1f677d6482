package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.check.law.Findings;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;

import java.util.HashMap;
import java.util.Map;

/**
 * ARC0214: each component and each type gives a Java class of its own. The class of a component
 * lies in the package of the model and its layer, that of a type in the package of its diagram.
 */
public final class JavaClassUnique implements Check.OnWorkspace {

    private record Model(String qualifiedName, Span place) {}

    @Override
    public void check(Workspace workspace, Findings findings) {
        Map<String, Model> seen = new HashMap<>();
        for (ComponentSymbol component : workspace.components()) {
            Model model = new Model(component.qualifiedName(), component.nameSpan());
            if (!isDeclaredTwice(component)) {
                check(javaClass(component), model, seen, findings);
            }
        }
        for (DiagramSymbol diagram : workspace.diagrams()) {
            for (DefinedType type : diagram.types()) {
                Model model = new Model(type.qualifiedName(), type.nameSpan());
                if (!isDefinedTwice(type, diagram)) {
                    check("type " + type.qualifiedName(), model, seen, findings);
                }
            }
        }
    }

    private static void check(
            String javaClass, Model model, Map<String, Model> seen, Findings findings) {
        Model first = seen.putIfAbsent(javaClass, model);
        if (first != null) {
            boolean same = first.qualifiedName().equals(model.qualifiedName());
            findings.report(
                            model.place(),
                            same
                                    ? "'" + model.qualifiedName() + "' is defined twice; rename one"
                                    : "'"
                                            + model.qualifiedName()
                                            + "' and '"
                                            + first.qualifiedName()
                                            + "' give one Java class; rename one")
                    .related(first.place(), "'" + first.qualifiedName() + "'");
        }
    }

    /** Two inner components of one name are the business of {@link InnerComponentNamesUnique}. */
    private static boolean isDeclaredTwice(ComponentSymbol component) {
        if (component.enclosing().isEmpty()) {
            return false;
        }
        ComponentSymbol outer = component.enclosing().get();
        for (ComponentSymbol sibling : outer.innerComponents()) {
            if (sibling.name().equals(component.name())) {
                return sibling != component || isDeclaredTwice(outer);
            }
        }
        return false;
    }

    private static boolean isDefinedTwice(DefinedType type, DiagramSymbol diagram) {
        for (DefinedType sibling : diagram.types()) {
            if (sibling.text().equals(type.text())) {
                return sibling != type;
            }
        }
        return false;
    }

    private static String javaClass(ComponentSymbol component) {
        String packageName = component.unit().packageText();
        String name =
                packageName.isEmpty()
                        ? component.qualifiedName()
                        : component.qualifiedName().substring(packageName.length() + 1);
        return "%s.%s.%s"
                .formatted(
                        packageName, component.signature().layer().text(), name.replace(".", ""));
    }
}
