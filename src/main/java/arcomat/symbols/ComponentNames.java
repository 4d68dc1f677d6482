package arcomat.symbols;

import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;

/** What names inside a component mean: first what the components around define, then the file. */
final class ComponentNames {
    private ComponentNames() {}

    /** A type parameter of the component or of one around it, or a type that the file reaches. */
    static Resolution<TypeSymbol> type(ComponentSymbol place, QualifiedName name) {
        if (name.isSimple()) {
            for (ComponentSymbol c = place; c != null; c = c.enclosing().orElse(null)) {
                for (TypeVariable variable : c.typeParameters()) {
                    if (variable.text().equals(name.text())) {
                        return new Resolution.Found<>(variable);
                    }
                }
            }
        }
        return place.unitScope().type(name);
    }

    /** An inner component, also of those around and above, or one that the file reaches. */
    static Resolution<ComponentSymbol> component(ComponentSymbol place, QualifiedName name) {
        for (ComponentSymbol c = place; c != null; c = c.enclosing().orElse(null)) {
            for (ComponentSymbol level : c.lineage()) {
                List<ComponentSymbol> found = inside(level, name);
                if (!found.isEmpty()) {
                    return Resolution.of(found);
                }
            }
        }
        return place.unitScope().component(name);
    }

    /**
     * The component that a super clause names. Inherited inner components do not count: they would
     * have to be known before.
     */
    static Resolution<ComponentSymbol> superComponent(ComponentSymbol heir, QualifiedName name) {
        for (ComponentSymbol c = heir.enclosing().orElse(null);
                c != null;
                c = c.enclosing().orElse(null)) {
            List<ComponentSymbol> found = inside(c, name);
            if (!found.isEmpty()) {
                return Resolution.of(found);
            }
        }
        return heir.unitScope().component(name);
    }

    private static List<ComponentSymbol> inside(ComponentSymbol place, QualifiedName path) {
        if (place.innerComponents().isEmpty()) {
            return List.of();
        }
        List<ComponentSymbol> level = List.of(place);
        for (Name part : path.parts()) {
            List<ComponentSymbol> next = new ArrayList<>();
            for (ComponentSymbol component : level) {
                component.innerComponents().stream()
                        .filter(c -> c.name().equals(part.text()))
                        .forEach(next::add);
            }
            level = next;
        }
        return level;
    }
}
