package arcomat.check;

import arcomat.symbols.BuiltinType;
import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.DefinedType;
import arcomat.symbols.DiagramSymbol;
import arcomat.symbols.TypeVariable;
import arcomat.symbols.Workspace;
import arcomat.tree.Import;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;

/**
 * The simple names that can be written at some place, to guess what a misspelled one was meant to
 * be. Computed for findings only.
 */
final class VisibleNames {
    private VisibleNames() {}

    /** Components: those inside the ones around, those of the package, imported ones. */
    static List<String> components(ComponentSymbol place, Context context) {
        List<String> names = new ArrayList<>();
        for (ComponentSymbol c = place; c != null; c = c.enclosing().orElse(null)) {
            for (ComponentSymbol inner : c.innerComponents()) {
                names.add(inner.name());
            }
        }
        for (ComponentSymbol component : context.workspace().topLevelComponents()) {
            if (isReached(component.qualifiedName(), context)) {
                names.add(component.name());
            }
        }
        return names;
    }

    /** Full names of message types of a simple name, in whatever package. */
    static List<String> typesElsewhere(QualifiedName name, Context context) {
        return context.workspace().diagrams().stream()
                .flatMap(diagram -> diagram.types().stream())
                .filter(type -> name.isSimple() && type.text().equals(name.text()))
                .map(DefinedType::qualifiedName)
                .distinct()
                .toList();
    }

    /** Full names of top-level components of a simple name, in whatever package. */
    static List<String> componentsElsewhere(QualifiedName name, Context context) {
        return context.workspace().topLevelComponents().stream()
                .filter(component -> name.isSimple() && component.name().equals(name.text()))
                .filter(component -> !component.unit().packageText().isEmpty())
                .map(ComponentSymbol::qualifiedName)
                .distinct()
                .toList();
    }

    /** Message types: type parameters, built-in ones, those of the package, imported ones. */
    static List<String> types(Context context) {
        List<String> names = new ArrayList<>();
        ComponentSymbol place = context.component().orElse(null);
        for (ComponentSymbol c = place; c != null; c = c.enclosing().orElse(null)) {
            for (TypeVariable parameter : c.typeParameters()) {
                names.add(parameter.text());
            }
        }
        for (BuiltinType type : BuiltinType.values()) {
            names.add(type.text());
        }
        for (DiagramSymbol diagram : context.workspace().diagrams()) {
            for (DefinedType type : diagram.types()) {
                if (isReached(type.qualifiedName(), context)) {
                    names.add(type.text());
                }
            }
        }
        return names;
    }

    /** What an import could name: packages do not count. */
    static List<String> qualified(Workspace workspace) {
        List<String> names = new ArrayList<>();
        for (ComponentSymbol component : workspace.topLevelComponents()) {
            names.add(component.qualifiedName());
        }
        for (DiagramSymbol diagram : workspace.diagrams()) {
            names.add(diagram.qualifiedName());
            for (DefinedType type : diagram.types()) {
                names.add(type.qualifiedName());
            }
        }
        return names;
    }

    private static boolean isReached(String qualifiedName, Context context) {
        int dot = qualifiedName.lastIndexOf('.');
        String qualifier = dot < 0 ? "" : qualifiedName.substring(0, dot);
        if (qualifier.equals(context.unit().packageText())) {
            return true;
        }
        for (Import each : context.unit().imports()) {
            if (each.name().text().equals(each.wildcard() ? qualifier : qualifiedName)) {
                return true;
            }
        }
        return false;
    }
}
