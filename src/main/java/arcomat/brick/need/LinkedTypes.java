package arcomat.brick.need;

import org.jspecify.annotations.Nullable;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/**
 * The classes that a program may be linked of, its own and leJOS', and where methods are declared.
 */
final class LinkedTypes {
    private final Code code;
    private final LibraryLinks library;
    private final Map<String, LinkedType> types = new HashMap<>();
    private final Set<String> unknown = new HashSet<>();

    /**
     * A method as it is declared.
     *
     * @param signature name and descriptor
     */
    record Method(String owner, String signature) {}

    LinkedTypes(Code code, LibraryLinks library) {
        this.code = code;
        this.library = library;
    }

    /** Whether all classes that were asked for are there. */
    boolean areComplete() {
        return unknown.isEmpty();
    }

    boolean isOfProgram(String type) {
        return code.type(type).isPresent();
    }

    /** Null where no class has the name. */
    @Nullable LinkedType type(String name) {
        LinkedType known = types.get(name);
        if (known == null) {
            known = code.type(name).map(ProgramLinks::of).or(() -> library.type(name)).orElse(null);
            if (known == null) {
                unknown.add(name);
            } else {
                types.put(name, known);
            }
        }
        return known;
    }

    /** A class and those above it; a damaged one may be above itself. */
    Set<String> lineage(String type) {
        Set<String> all = new LinkedHashSet<>();
        String at = type;
        while (at != null && all.add(at)) {
            LinkedType own = type(at);
            at = own == null ? null : own.parent().orElse(null);
        }
        return all;
    }

    /** A class, then its interfaces, each with those that it extends. */
    Set<String> withInterfaces(String type) {
        Set<String> all = new LinkedHashSet<>();
        addInterfaces(type, all);
        return all;
    }

    private void addInterfaces(String type, Set<String> all) {
        LinkedType own = all.add(type) ? type(type) : null;
        if (own != null) {
            own.interfaces().forEach(each -> addInterfaces(each, all));
        }
    }

    /** What a call of that method calls where no object decides; null for none. */
    @Nullable Method inClasses(String type, String signature) {
        return declared(lineage(type), signature);
    }

    /** The method of an interface, or of one that it extends; null for none. */
    @Nullable Method inInterfaces(String type, String signature) {
        return declared(withInterfaces(type), signature);
    }

    /** The method that those of subclasses override; null for none. */
    @Nullable Method virtual(String type, String signature) {
        for (String each : lineage(type)) {
            Method found = inInterfaces(each, signature);
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    private @Nullable Method declared(Set<String> types, String signature) {
        for (String each : types) {
            LinkedType own = type(each);
            if (own != null && own.methods().containsKey(signature)) {
                return new Method(each, signature);
            }
        }
        return null;
    }
}
