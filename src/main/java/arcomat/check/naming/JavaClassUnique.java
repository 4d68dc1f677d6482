package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;

import java.util.ArrayList;
import java.util.List;

/**
 * ARC0214: each component and each type gives a Java class of its own. The class of a component
 * lies in the package of the model and its layer, that of a type in the package of its diagram.
 */
public final class JavaClassUnique implements Check.OnWorkspace {

    private record Model(String javaClass, String qualifiedName, Span place) {}

    @Override
    public void check(Workspace workspace, Findings findings) {
        List<Model> models = new ArrayList<>();
        for (ComponentSymbol c : workspace.components()) {
            if (!isDeclaredTwice(c)) {
                models.add(new Model(javaClass(c), c.qualifiedName(), c.nameSpan()));
            }
        }
        for (DiagramSymbol diagram : workspace.diagrams()) {
            for (DefinedType type : diagram.types()) {
                if (!isDefinedTwice(type, diagram)) {
                    String name = type.qualifiedName();
                    models.add(new Model("type " + name, name, type.nameSpan()));
                }
            }
        }
        Duplicates.report(models, Model::javaClass, (m, first) -> report(m, first, findings));
    }

    private static void report(Model model, Model first, Findings findings) {
        boolean same = first.qualifiedName().equals(model.qualifiedName());
        findings.report(
                        model.place(),
                        same
                                ? "'%s' is defined twice; rename one"
                                : "'%s' and '%s' give one Java class; rename one",
                        model.qualifiedName(),
                        first.qualifiedName())
                .related(first.place(), "'" + first.qualifiedName() + "'");
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
        return diagram.types().stream()
                .filter(sibling -> sibling.text().equals(type.text()))
                .findFirst()
                .filter(first -> first != type)
                .isPresent();
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
