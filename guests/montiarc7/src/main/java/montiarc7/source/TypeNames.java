package montiarc7.source;

import montiarc7.grammar.MontiArc7Parser;
import montiarc7.grammar.MontiArc7Parser.CallExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ImportingContext;
import montiarc7.grammar.MontiArc7Parser.NewExpressionContext;
import montiarc7.grammar.MontiArc7Parser.TypeContext;
import montiarc7.grammar.MontiArc7Parser.UnitContext;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** What the names of types in one file mean, and what the converted file has to import. */
public final class TypeNames {
    /** Java's boxed and simple types are one here. */
    private static final Map<String, String> OWN =
            Map.ofEntries(
                    Map.entry("int", "Integer"),
                    Map.entry("Integer", "Integer"),
                    Map.entry("boolean", "Boolean"),
                    Map.entry("Boolean", "Boolean"),
                    Map.entry("long", "Long"),
                    Map.entry("Long", "Long"),
                    Map.entry("double", "Double"),
                    Map.entry("Double", "Double"),
                    Map.entry("float", "float"),
                    Map.entry("Float", "float"),
                    Map.entry("byte", "byte"),
                    Map.entry("Byte", "byte"),
                    Map.entry("short", "short"),
                    Map.entry("Short", "short"),
                    Map.entry("char", "char"),
                    Map.entry("Character", "char"),
                    Map.entry("String", "String"));

    /** Types that every Java file knows, and that Arcomat compares type arguments with. */
    private static final Set<String> JAVA =
            Set.of(
                    "CharSequence",
                    "Cloneable",
                    "Comparable",
                    "Enum",
                    "Iterable",
                    "Number",
                    "Object",
                    "Runnable");

    private static final String LANGUAGE = "java.lang.";

    private final UnitContext unit;
    private final String packageName;
    private final Folder folder;
    private final Lacks lacks;
    private final Set<String> parameters = new HashSet<>();
    private final Set<String> inner = new HashSet<>();
    private final Set<String> noted = new HashSet<>();

    /** What is given to methods, which may change what is in it. */
    private final List<ExpressionContext> given = new ArrayList<>();

    private final Set<String> imports = new TreeSet<>();

    public TypeNames(UnitContext unit, Folder folder, Lacks lacks) {
        this.unit = unit;
        this.packageName = packageOf(unit);
        this.folder = folder;
        this.lacks = lacks;
        unit.importing().forEach(this::keep);
    }

    public static String packageOf(UnitContext unit) {
        return unit.qname() == null ? "" : unit.qname().getText();
    }

    /** Of components; types are imported where they are used. */
    private void keep(ImportingContext each) {
        String name = each.qname().getText();
        if (isStar(each) ? folder.hasPackage(name) : folder.hasComponent(name)) {
            imports.add(isStar(each) ? name + ".*" : name);
        }
    }

    private static boolean isStar(ImportingContext each) {
        return each.getText().endsWith(".*;");
    }

    /** The names that a component brings for all that is in it. */
    public void enter(ComponentContext component) {
        if (component.typeParameters() != null) {
            component
                    .typeParameters()
                    .typeParameter()
                    .forEach(each -> parameters.add(each.name().getText()));
        }
        Placed.of(component.element()).stream()
                .map(Placed::element)
                .filter(MontiArc7Parser.InnerElementContext.class::isInstance)
                .map(MontiArc7Parser.InnerElementContext.class::cast)
                .forEach(each -> inner.add(each.component().name(0).getText()));
        collectGiven(component);
    }

    private void collectGiven(ParserRuleContext tree) {
        for (var child : tree.children) {
            if (child instanceof ParserRuleContext inner && inner.children != null) {
                boolean isArgument =
                        child instanceof ExpressionContext
                                && child != tree.getChild(0)
                                && (tree instanceof CallExpressionContext
                                        || tree instanceof NewExpressionContext);
                if (isArgument && !tree.getChild(0).getText().endsWith(".equals")) {
                    given.add((ExpressionContext) child);
                }
                collectGiven(inner);
            }
        }
    }

    /** What methods get. */
    public List<ExpressionContext> given() {
        return given;
    }

    /**
     * Whether it is of a type of which nobody can change what is in it: a number, a text, a
     * constant.
     */
    public boolean isValue(String type) {
        String simple = ClassText.simple(type);
        return OWN.containsKey(simple) || folder.constants(simple).isPresent();
    }

    public Set<String> imports() {
        return imports;
    }

    /** A type of messages. */
    public String message(TypeContext type) {
        if (type.getText().endsWith("]")) {
            lacks.missing(
                    Lack.STRUCTURE,
                    type,
                    "arrays are not converted; use a port or a field for each element");
        }
        return known(type).orElseGet(() -> opaque(type, plain(type)));
    }

    /** Whether nobody here knows what a type has for values. */
    public boolean isOpaque(TypeContext type) {
        return known(type).isEmpty();
    }

    /** What arguments of a type parameter have to be; nothing where nobody here knows the type. */
    public Optional<String> bound(TypeContext type) {
        Optional<String> known = known(type).or(() -> java(type));
        if (known.isEmpty()) {
            lacks.note(
                    Lack.OPAQUE,
                    type,
                    "'%s' is defined in no class diagram here; it is left out, and any type may stand for the parameter"
                            .formatted(type.getText()));
        }
        return known;
    }

    /** A type of java.lang, with its arguments where all of them are known. */
    private Optional<String> java(TypeContext type) {
        String plain = plain(type);
        if (!JAVA.contains(plain) || !isOfJava(type.qname().getText(), plain)) {
            return Optional.empty();
        }
        List<TypeContext> arguments =
                type.typeArguments() == null ? List.of() : type.typeArguments().type();
        List<String> known = arguments.stream().flatMap(each -> this.known(each).stream()).toList();
        boolean isComplete = !known.isEmpty() && known.size() == arguments.size();
        return Optional.of(isComplete ? plain + "<" + String.join(", ", known) + ">" : plain);
    }

    private boolean isOfJava(String name, String plain) {
        return name.equals(plain)
                ? unit.importing().stream()
                        .map(each -> each.qname().getText())
                        .filter(each -> each.endsWith("." + plain))
                        .allMatch((LANGUAGE + plain)::equals)
                : name.equals(LANGUAGE + plain);
    }

    /** A type of Arcomat, of a class diagram, or that a parameter stands for. */
    private Optional<String> known(TypeContext type) {
        String name = type.qname().getText();
        String plain = plain(type);
        String own = name.equals(plain) || name.startsWith(LANGUAGE) ? OWN.get(plain) : null;
        if (own != null) {
            return Optional.of(own);
        }
        if (parameters.contains(name)) {
            return Optional.of(name);
        }
        Optional<String> known = diagram(name);
        known.ifPresent(each -> imports.add(each + "." + plain));
        return known.map(each -> plain);
    }

    private static String plain(TypeContext type) {
        String name = type.qname().getText();
        return name.substring(name.lastIndexOf('.') + 1);
    }

    private String opaque(TypeContext type, String plain) {
        String name = plain;
        if (type.typeArguments() != null) {
            name +=
                    "Of"
                            + type.typeArguments().type().stream()
                                    .map(each -> each.qname().getText())
                                    .map(each -> each.substring(each.lastIndexOf('.') + 1))
                                    .collect(Collectors.joining("And"));
        }
        if (noted.add(name)) {
            lacks.note(
                    Lack.OPAQUE,
                    type,
                    "'%s' is defined in no class diagram here; its messages are passed on and compared, as those of '%s.%s'"
                            .formatted(type.getText(), Folder.OPAQUE, name));
        }
        folder.addOpaque(name);
        imports.add(Folder.OPAQUE + "." + name);
        return name;
    }

    /** A type of messages by its full name, which nothing has to import. */
    public String full(TypeContext type) {
        String name = message(type);
        return imports.stream().filter(each -> each.endsWith("." + name)).findFirst().orElse(name);
    }

    /** The type of an attribute that objects of some type have; nothing where they have none. */
    public Optional<String> attribute(String type, String attribute) {
        return isType(type)
                ? folder.attribute(ClassText.simple(type), attribute)
                : Optional.empty();
    }

    /** Whether a name stands for a type of a class diagram. */
    public boolean isType(String name) {
        return diagram(name).isPresent();
    }

    /** The same; it is imported then. */
    public boolean refersToEnum(String name) {
        Optional<String> known = diagram(name);
        String plain = name.substring(name.lastIndexOf('.') + 1);
        known.ifPresent(each -> imports.add(each + "." + plain));
        return known.isPresent();
    }

    private Optional<String> diagram(String name) {
        String plain = name.substring(name.lastIndexOf('.') + 1);
        String qualifier = Folder.packageOf(name);
        if (!qualifier.isEmpty()) {
            return folder.diagram(qualifier, plain)
                    .or(() -> folder.diagram(Folder.qualified(packageName, qualifier), plain))
                    .or(() -> folder.diagramIn(qualifier, plain));
        }
        for (ImportingContext each : unit.importing()) {
            for (String from : places(each, plain)) {
                Optional<String> found =
                        folder.diagram(from, plain)
                                .or(
                                        () ->
                                                folder.diagram(
                                                        Folder.qualified(packageName, from), plain))
                                .or(() -> folder.diagramIn(from, plain));
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return folder.diagramIn(packageName, plain);
    }

    /**
     * Diagrams or packages from which an import may bring a type of that name: with a type, too,
     * come all its constants, or one of them.
     */
    private static List<String> places(ImportingContext each, String plain) {
        String full = each.qname().getText();
        String around = Folder.packageOf(full);
        List<String> places = new ArrayList<>();
        if (isStar(each)) {
            places.add(full);
        }
        if (full.endsWith("." + plain)) {
            places.add(around);
        }
        if (!isStar(each) && around.endsWith("." + plain)) {
            places.add(Folder.packageOf(around));
        }
        return places;
    }

    /** A type of parts, or of what is extended. */
    public String component(TypeContext type) {
        String text = type.qname().getText();
        if (type.typeArguments() == null) {
            return text;
        }
        return type.typeArguments().type().stream()
                .map(this::message)
                .collect(Collectors.joining(", ", text + "<", ">"));
    }
}
