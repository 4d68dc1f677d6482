package arcomat.check.facts;

import arcomat.check.law.Check.Context;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.Names;
import arcomat.symbols.names.Outline;
import arcomat.symbols.names.TypeVariable;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The simple names that can be written at some place, to guess what a misspelled one was meant to
 * be. Computed for findings only.
 */
public final class VisibleNames {
    private VisibleNames() {}

    /** Components: those inside the ones around, those of the package, imported ones. */
    public static List<String> components(ComponentSymbol place, Context context) {
        List<String> names = new ArrayList<>();
        for (ComponentSymbol c = place; c != null; c = c.enclosing().orElse(null)) {
            for (ComponentSymbol inner : c.innerComponents()) {
                names.add(inner.name());
            }
        }
        for (Outline file : context.workspace().outlines()) {
            file.topLevelComponent()
                    .filter(component -> isReached(component, context))
                    .ifPresent(component -> names.add(Outline.simple(component)));
        }
        return names;
    }

    /** Full names of message types of a simple name, in whatever package. */
    public static List<String> typesElsewhere(QualifiedName name, Context context) {
        return elsewhere(name, context, file -> file.types().stream());
    }

    /** Full names of top-level components of a simple name, in whatever named package. */
    public static List<String> componentsElsewhere(QualifiedName name, Context context) {
        return elsewhere(
                name,
                context,
                file ->
                        file.topLevelComponent().stream()
                                .filter(component -> !file.packageName().isEmpty()));
    }

    private static List<String> elsewhere(
            QualifiedName name, Context context, Function<Outline, Stream<String>> defined) {
        return context.workspace().outlines().stream()
                .flatMap(defined)
                .filter(each -> name.isSimple() && Outline.simple(each).equals(name.text()))
                .distinct()
                .toList();
    }

    /** Message types: type parameters, built-in ones, those of the package, imported ones. */
    public static List<String> types(Context context) {
        List<String> names = new ArrayList<>();
        ComponentSymbol place = context.component().orElse(null);
        for (ComponentSymbol c = place; c != null; c = c.enclosing().orElse(null)) {
            for (TypeVariable parameter : c.signature().typeParameters()) {
                names.add(parameter.text());
            }
        }
        for (BuiltinType type : BuiltinType.values()) {
            names.add(type.text());
        }
        for (Outline file : context.workspace().outlines()) {
            file.types().stream()
                    .filter(
                            type ->
                                    isReached(type, context)
                                            || isReachedByPackage(file, type, context))
                    .forEach(type -> names.add(Outline.simple(type)));
        }
        return names;
    }

    /** Without its diagram. */
    private static boolean isReachedByPackage(Outline file, String type, Context context) {
        return !file.packageName().isEmpty()
                && isReached(Names.join(file.packageName(), Outline.simple(type)), context);
    }

    /** What an import could name: packages do not count. */
    public static List<String> qualified(Workspace workspace) {
        List<String> names = new ArrayList<>();
        for (Outline file : workspace.outlines()) {
            file.topLevelComponent().ifPresent(names::add);
            file.diagram().ifPresent(names::add);
            names.addAll(file.types());
        }
        return names;
    }

    private static boolean isReached(String qualifiedName, Context context) {
        String qualifier = Names.qualifier(qualifiedName);
        if (qualifier.equals(context.unit().packageText())) {
            return true;
        }
        return context.unit().imports().stream()
                .anyMatch(i -> i.name().text().equals(i.wildcard() ? qualifier : qualifiedName));
    }
}
