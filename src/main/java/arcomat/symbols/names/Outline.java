package arcomat.symbols.names;

import arcomat.tree.ClassDiagram;
import arcomat.tree.Component;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The names that a file defines, as far as other files can see them. All are qualified.
 *
 * @param packageName empty for the default package
 * @param components the top-level component, then those inside it; empty in other files
 * @param diagram the class diagram; empty in other files
 * @param types those of the class diagram
 */
public record Outline(
        String packageName, List<String> components, Optional<String> diagram, List<String> types) {
    public Outline {
        components = List.copyOf(components);
        types = List.copyOf(types);
    }

    public static Outline of(Unit unit) {
        String packageName = unit.packageText();
        List<String> components = new ArrayList<>();
        List<String> types = new ArrayList<>();
        Optional<String> diagram = Optional.empty();
        if (unit.definition() instanceof Component component) {
            add(component, packageName, components);
        } else if (unit.definition() instanceof ClassDiagram node) {
            String name = Names.join(packageName, node.name().text());
            node.types().forEach(type -> types.add(Names.join(name, type.name().text())));
            diagram = Optional.of(name);
        }
        return new Outline(packageName, components, diagram, types);
    }

    private static void add(Component component, String qualifier, List<String> components) {
        String name = Names.join(qualifier, component.name().text());
        components.add(name);
        component.elements(Component.class).forEach(inner -> add(inner, name, components));
    }

    public Optional<String> topLevelComponent() {
        return components.stream().findFirst();
    }

    /** The last part of a qualified name. */
    public static String simple(String qualifiedName) {
        return qualifiedName.substring(qualifiedName.lastIndexOf('.') + 1);
    }
}
