package arcomat.symbols.names;

import arcomat.tree.ClassDiagram;
import arcomat.tree.Component;
import arcomat.tree.Definition;
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
        String home = unit.packageText();
        Outline nothing = new Outline(home, List.of(), Optional.empty(), List.of());
        return unit.definition()
                .match(
                        new Definition.Cases<>(
                                component -> ofComponent(home, component),
                                automaton -> nothing,
                                diagram -> ofDiagram(home, diagram),
                                suite -> nothing));
    }

    private static Outline ofComponent(String home, Component component) {
        List<String> components = new ArrayList<>();
        Component all = Variants.of(component).map(Variants::everything).orElse(component);
        add(all, home, components);
        return new Outline(home, components, Optional.empty(), List.of());
    }

    private static Outline ofDiagram(String home, ClassDiagram diagram) {
        String name = Names.join(home, diagram.name().text());
        List<String> types =
                diagram.types().stream().map(t -> Names.join(name, t.name().text())).toList();
        return new Outline(home, List.of(), Optional.of(name), types);
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
