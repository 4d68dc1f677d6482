package arcomat.symbols.names;

import arcomat.source.ComposedForm;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Everything that has a qualified name, duplicates included. Filled once, then only read. */
public final class Index {
    private final Map<String, List<DefinedType>> types = new HashMap<>();
    private final Map<String, List<DefinedType>> typesOfPackages = new HashMap<>();
    private final Map<String, List<ComponentDeclaration>> components = new HashMap<>();
    private final Set<String> qualifiers = new HashSet<>();
    private final Map<String, List<String>> brokenByName = new HashMap<>();
    private final Set<String> foldersOfBrokenDiagrams = new HashSet<>();

    public void add(DefinedType type) {
        types.computeIfAbsent(type.qualifiedName(), name -> new ArrayList<>(1)).add(type);
        if (type.unit().packageName().isPresent()) {
            typesOfPackages.computeIfAbsent(type.shortName(), name -> new ArrayList<>(1)).add(type);
        }
    }

    public void add(ComponentDeclaration component) {
        components
                .computeIfAbsent(component.qualifiedName(), n -> new ArrayList<>(1))
                .add(component);
    }

    /** Notes that a package, a diagram or a component with that name exists. */
    public void addQualifier(String name) {
        String current = name;
        while (!current.isEmpty() && qualifiers.add(current)) {
            current = Names.qualifier(current);
        }
    }

    /** Notes the packages, components and diagrams of a file that is not looked at. */
    public void addQualifiers(Outline outline) {
        addQualifier(outline.packageName());
        outline.components().forEach(this::addQualifier);
        outline.diagram().ifPresent(this::addQualifier);
    }

    /** Notes a file without a tree: whatever it should define is excused. */
    public void addBroken(String file) {
        String path = ComposedForm.of(file); // as names are
        String name = path.substring(path.lastIndexOf('/') + 1);
        int dot = name.lastIndexOf('.');
        String simple = dot < 0 ? name : name.substring(0, dot);
        int slash = path.lastIndexOf('/');
        String folder = slash < 0 ? "" : path.substring(0, slash).replace('/', '.');
        if (path.endsWith(".cd")) {
            foldersOfBrokenDiagrams.add(folder);
        }
        brokenByName
                .computeIfAbsent(simple, n -> new ArrayList<>(1))
                .add(Names.join(folder, simple));
    }

    public List<DefinedType> types(String qualifiedName) {
        return types.getOrDefault(qualifiedName, List.of());
    }

    /** The types of all diagrams of a named package that are reached without their diagram. */
    public List<DefinedType> typesOfPackage(String shortName) {
        return typesOfPackages.getOrDefault(shortName, List.of());
    }

    public List<ComponentDeclaration> components(String qualifiedName) {
        return components.getOrDefault(qualifiedName, List.of());
    }

    /** Whether a package, a diagram or a component has that qualified name. */
    boolean isQualifier(String name) {
        return qualifiers.contains(name);
    }

    /** Whether the name, or what it lies in, should stand in a file that did not parse. */
    boolean isExcused(String qualifiedName) {
        if (brokenByName.isEmpty()) {
            return false;
        }
        String current = qualifiedName;
        while (!current.isEmpty() && !isBroken(current)) {
            current = Names.qualifier(current);
        }
        return !current.isEmpty();
    }

    private boolean isBroken(String qualifiedName) {
        String simple = qualifiedName.substring(qualifiedName.lastIndexOf('.') + 1);
        return brokenByName.getOrDefault(simple, List.of()).stream()
                .anyMatch(path -> path.equals(qualifiedName) || path.endsWith("." + qualifiedName));
    }

    /** Whether a file that did not parse should lie in that package. */
    boolean hasBrokenFileIn(String packageName) {
        return brokenByName.values().stream()
                .flatMap(List::stream)
                .map(Names::qualifier)
                .anyMatch(folder -> mayHold(folder, packageName));
    }

    /** Whether a type of that name, without its diagram, may stand in a file that did not parse. */
    boolean isExcusedType(String shortName) {
        String packageName = Names.qualifier(shortName);
        return !packageName.isEmpty()
                && foldersOfBrokenDiagrams.stream()
                        .anyMatch(folder -> mayHold(folder, packageName));
    }

    private static boolean mayHold(String folder, String packageName) {
        return folder.equals(packageName) || folder.endsWith("." + packageName);
    }
}
