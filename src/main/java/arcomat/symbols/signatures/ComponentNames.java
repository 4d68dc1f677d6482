package arcomat.symbols.signatures;

import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.TypeVariable;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;

/** What names inside a component mean: first what the components around define, then the file. */
final class ComponentNames {
    private ComponentNames() {}

    /** A type parameter of the component or of one around it, or a type that the file reaches. */
    static Resolution<TypeSymbol> type(Signature place, QualifiedName name) {
        if (name.isSimple()) {
            for (Signature c = place; c != null; c = c.enclosing().orElse(null)) {
                for (TypeVariable variable : c.typeParameters()) {
                    if (variable.text().equals(name.text())) {
                        return new Resolution.Found<>(variable);
                    }
                }
            }
        }
        Resolution<TypeSymbol> found = place.declaration().unitScope().type(name);
        return found.found().orElse(null) instanceof JavaType && isInner(place, name)
                ? Resolution.unknown()
                : found;
    }

    /** A component hides what Java alone calls by this name. */
    private static boolean isInner(Signature place, QualifiedName name) {
        for (Signature c = place; c != null; c = c.enclosing().orElse(null)) {
            if (!inside(c, name).isEmpty()) {
                return true;
            }
        }
        return false;
    }

    /** An inner component, also of those around and above, or one that the file reaches. */
    static Resolution<Signature> component(Signature place, QualifiedName name) {
        for (Signature c = place; c != null; c = c.enclosing().orElse(null)) {
            for (Signature level : c.lineage()) {
                List<Signature> found = inside(level, name);
                if (!found.isEmpty()) {
                    return Resolution.of(found);
                }
            }
        }
        return fromFile(place, name);
    }

    /**
     * The component that a super clause names. Inherited inner components do not count: they would
     * have to be known before.
     */
    static Resolution<Signature> superComponent(Signature heir, QualifiedName name) {
        for (Signature c = heir.enclosing().orElse(null);
                c != null;
                c = c.enclosing().orElse(null)) {
            List<Signature> found = inside(c, name);
            if (!found.isEmpty()) {
                return Resolution.of(found);
            }
        }
        return fromFile(heir, name);
    }

    private static Resolution<Signature> fromFile(Signature place, QualifiedName name) {
        return place.declaration().unitScope().component(name).map(place::of);
    }

    private static List<Signature> inside(Signature place, QualifiedName path) {
        if (place.innerComponents().isEmpty()) {
            return List.of();
        }
        List<Signature> level = List.of(place);
        for (Name part : path.parts()) {
            List<Signature> next = new ArrayList<>();
            for (Signature component : level) {
                component.innerComponents().stream()
                        .filter(c -> c.name().equals(part.text()))
                        .forEach(next::add);
            }
            level = next;
        }
        return level;
    }
}
