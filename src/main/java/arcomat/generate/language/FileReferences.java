package arcomat.generate.language;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The types that one generated file mentions. A type is imported and named briefly unless its brief
 * name means something else in the file.
 */
public final class FileReferences {
    private final TargetLanguage language;
    private final TypeName self;
    private final Map<String, TypeName> brief = new LinkedHashMap<>();
    private final Map<String, TypeName> mentioned = new TreeMap<>();

    public FileReferences(TargetLanguage language, TypeName self) {
        this.language = language;
        this.self = self;
        brief.put(self.name(), self);
    }

    /** How the file names a type. */
    public String to(TypeName type) {
        TypeName holder = brief.putIfAbsent(type.name(), type);
        boolean free = holder == null || holder.equals(type);
        if (free) {
            mentioned.put(type.qualified(), type);
        }
        return language.spell(
                free ? "reference.brief" : "reference.full",
                Map.of(
                        "package", type.packageName(),
                        "prefix", type.prefix(),
                        "name", type.name(),
                        "qualified", type.qualified()));
    }

    /** The types that are named briefly, in alphabetical order. */
    public List<TypeName> mentioned() {
        return List.copyOf(mentioned.values());
    }

    /** Whether a type lives in the package of the file itself. */
    public boolean isNeighbour(TypeName type) {
        return type.packageName().equals(self.packageName());
    }

    /** All brief names that mean a type here. */
    public Iterable<String> briefNames() {
        return brief.keySet();
    }
}
