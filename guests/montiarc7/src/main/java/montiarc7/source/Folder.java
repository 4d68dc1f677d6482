package montiarc7.source;

import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.PortDeclarationContext;
import montiarc7.grammar.MontiArc7Parser.PortsElementContext;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What there is in all files of the folder: components, types, and types from elsewhere. */
public final class Folder {
    /** The class diagram of types that no file defines. */
    static final String OPAQUE = "imported.Types";

    private static final Pattern COMMENT = Pattern.compile("(?s)/\\*.*?\\*/|//[^\\n]*");
    private static final Pattern PACKAGE = Pattern.compile("\\bpackage\\s+([\\w.]+)\\s*;");
    private static final Pattern DIAGRAM = Pattern.compile("\\bclassdiagram\\s+(\\w+)");
    private static final Pattern TYPE =
            Pattern.compile("\\b(?:enum|class|interface|type)\\s+(\\w+)");

    private static final Pattern ENUM = Pattern.compile("\\benum\\s+(\\w+)[^{}]*\\{\\s*([^;}]*)");

    /** Full names of class diagrams, with the types in them. */
    private final Map<String, Set<String>> diagrams = new LinkedHashMap<>();

    /**
     * Constants of enumerations, by simple names; several lists where enumerations share a name.
     */
    private final Map<String, Set<List<String>>> constants = new HashMap<>();

    /** By simple names; several where classes share a name. */
    private final Map<String, Set<ClassText>> classes = new HashMap<>();

    private final Map<String, ComponentContext> components = new HashMap<>();
    private final Set<String> packages = new HashSet<>();
    private final Set<String> opaque = new TreeSet<>();

    /** The full name of the diagram that a text defines. */
    public Optional<String> addDiagram(String text) {
        String code = COMMENT.matcher(text).replaceAll(" ");
        Matcher name = DIAGRAM.matcher(code);
        if (!name.find()) {
            return Optional.empty();
        }
        Matcher place = PACKAGE.matcher(code);
        String full = place.find() ? place.group(1) + "." + name.group(1) : name.group(1);
        Set<String> types = new HashSet<>();
        Matcher type = TYPE.matcher(code);
        while (type.find()) {
            types.add(type.group(1));
        }
        diagrams.put(full, types);
        ClassText.of(code)
                .forEach(
                        (each, found) ->
                                classes.computeIfAbsent(each, all -> new HashSet<>()).add(found));
        Matcher enumeration = ENUM.matcher(code.replaceAll("\\([^()]*\\)", ""));
        while (enumeration.find()) {
            constants
                    .computeIfAbsent(enumeration.group(1), each -> new HashSet<>())
                    .add(List.of(enumeration.group(2).trim().split("\\s*,\\s*")));
        }
        return Optional.of(full);
    }

    /**
     * The type of an attribute of a class, or of one that it extends; nothing where several classes
     * have this simple name.
     */
    Optional<String> attribute(String simple, String attribute) {
        Set<String> seen = new HashSet<>();
        String at = simple;
        while (seen.add(at) && classes.getOrDefault(at, Set.of()).size() == 1) {
            ClassText text = classes.get(at).iterator().next();
            if (text.attributes().containsKey(attribute)) {
                return Optional.of(text.attributes().get(attribute));
            }
            at = text.parent();
        }
        return Optional.empty();
    }

    /** All constants of an enumeration; nothing where several have this simple name. */
    public Optional<List<String>> constants(String simple) {
        Set<List<String>> all = constants.getOrDefault(simple, Set.of());
        return all.size() == 1 ? Optional.of(all.iterator().next()) : Optional.empty();
    }

    public void addComponent(String packageName, ComponentContext component) {
        packages.add(packageName);
        components.put(qualified(packageName, component.name(0).getText()), component);
    }

    boolean hasPackage(String name) {
        return packages.contains(name);
    }

    boolean hasComponent(String full) {
        return components.containsKey(full);
    }

    public static String qualified(String packageName, String name) {
        return packageName.isEmpty() ? name : packageName + "." + name;
    }

    /** A component by its simple name, where only one has it. */
    public Optional<ComponentContext> component(String simple) {
        List<ComponentContext> found = new ArrayList<>();
        components.forEach(
                (full, each) -> {
                    if (full.equals(simple) || full.endsWith("." + simple)) {
                        found.add(each);
                    }
                });
        return found.size() == 1 ? Optional.of(found.get(0)) : Optional.empty();
    }

    /**
     * The ports in a direction, with those of components that this one extends.
     *
     * @param sides on which the ports are asked for
     */
    public Set<String> ports(
            ComponentContext component, String direction, List<Placed.Side> sides) {
        Set<String> names = new HashSet<>();
        Set<ComponentContext> seen = new HashSet<>();
        ComponentContext at = component;
        while (at != null && seen.add(at)) {
            for (Placed each : Placed.of(at.element())) {
                if (each.goesWith(sides) && each.element() instanceof PortsElementContext ports) {
                    for (PortDeclarationContext declared : ports.portDeclaration()) {
                        if (declared.direction.getText().equals(direction)) {
                            declared.name().forEach(name -> names.add(name.getText()));
                        }
                    }
                }
            }
            at =
                    at.parent().isEmpty()
                            ? null
                            : component(at.parent(0).type().qname().getText()).orElse(null);
        }
        return names;
    }

    /** The diagram of a name, if need be one that differs in capital letters only. */
    Optional<String> diagram(String full, String type) {
        return diagrams.entrySet().stream()
                .filter(each -> each.getKey().equalsIgnoreCase(full))
                .filter(each -> each.getValue().contains(type))
                .map(Map.Entry::getKey)
                .findFirst();
    }

    /** A diagram in a package that has a type. */
    Optional<String> diagramIn(String packageName, String type) {
        return diagrams.entrySet().stream()
                .filter(each -> packageOf(each.getKey()).equals(packageName))
                .filter(each -> each.getValue().contains(type))
                .map(Map.Entry::getKey)
                .findFirst();
    }

    static String packageOf(String full) {
        return full.contains(".") ? full.substring(0, full.lastIndexOf('.')) : "";
    }

    void addOpaque(String name) {
        opaque.add(name);
    }

    public Optional<String> opaqueDiagram() {
        if (opaque.isEmpty()) {
            return Optional.empty();
        }
        StringBuilder text = new StringBuilder("package imported;\n\n");
        text.append("/** Types that no file of the original defines. */\nclassdiagram Types {\n");
        opaque.forEach(each -> text.append("type ").append(each).append(";\n"));
        return Optional.of(text.append("}\n").toString());
    }
}
