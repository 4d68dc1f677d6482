package arcomat.generate.language;

import arcomat.model.Component;
import arcomat.model.Type;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * The identifiers of a generated program: every name of the model becomes a legal, unique name of
 * the target, the same one each time. Components live in the package of the model and their layer,
 * message types in the package of their class diagram.
 */
public final class TargetNames {
    private final TargetLanguage language;
    private final Map<String, UniqueNames> packages = new HashMap<>();
    private final Map<String, TypeName> types = new HashMap<>();
    private final Map<Type.ClassType, List<String>> attributes = new HashMap<>();
    private final Map<Type.EnumType, Map<Integer, EnumConstant>> constants = new HashMap<>();

    /**
     * @param name of the object of an enum
     * @param code name of the number that stands for it
     */
    public record EnumConstant(String name, String code) {}

    public TargetNames(TargetLanguage language) {
        this.language = language;
    }

    public TargetLanguage language() {
        return language;
    }

    /** The name of a component's class; asked first for what comes first in the model. */
    public TypeName of(Component component) {
        String layer = component.layer().name().toLowerCase(Locale.ROOT);
        return types.computeIfAbsent(
                "component " + component.qualifiedName(),
                key -> type(component.packageName() + "." + layer, component.name()));
    }

    /** The name of an enum or class of a class diagram. */
    public TypeName of(Type type) {
        if (type instanceof Type.ClassType object && object.java().isPresent()) {
            return types.computeIfAbsent(
                    "type " + type.name(), key -> type("java", object.simpleName()));
        }
        String qualified = type.name();
        int dot = qualified.lastIndexOf('.');
        String diagram = dot < 0 ? "types" : qualified.substring(0, dot);
        int inner = diagram.lastIndexOf('.') + 1;
        String home = home(diagram.substring(0, inner), diagram.substring(inner));
        return types.computeIfAbsent(
                "type " + qualified, key -> type(home, qualified.substring(dot + 1)));
    }

    /** The names of those types that are enums. */
    public Set<TypeName> ofEnums(List<Type> mentioned) {
        return mentioned.stream()
                .filter(Type.EnumType.class::isInstance)
                .map(this::of)
                .collect(Collectors.toSet());
    }

    /** {@code coffee.types.Types} and {@code coffee.Types} are both at home in coffee.types. */
    private static String home(String packageName, String diagram) {
        String own = NameForms.uncapitalised(diagram);
        boolean said = packageName.equals(own + ".") || packageName.endsWith("." + own + ".");
        return said ? packageName : packageName + own;
    }

    /** A further name beside a component's class. */
    public TypeName beside(Component component, String suffix) {
        TypeName self = of(component);
        return types.computeIfAbsent(
                "beside " + component.qualifiedName() + " " + suffix,
                key -> type(self.packageName(), self.name() + suffix));
    }

    private TypeName type(String packageName, String name) {
        String home =
                Arrays.stream(packageName.split("\\."))
                        .filter(segment -> !segment.isEmpty())
                        .map(this::segment)
                        .collect(Collectors.joining("."));
        UniqueNames scope =
                packages.computeIfAbsent(home, key -> UniqueNames.ofFiles(reservedTypes()));
        return TypeName.of(
                home, scope.claimAll(NameForms.type(name), language.words("companions")));
    }

    private String segment(String name) {
        String identifier = NameForms.identifier(name);
        boolean reserved =
                language.reserved().contains(identifier)
                        || Arrays.asList(language.words("reserved.packages")).contains(identifier);
        return reserved ? identifier + "_" : identifier;
    }

    private Set<String> reservedTypes() {
        Set<String> words = new TreeSet<>(language.reserved());
        words.addAll(Arrays.asList(language.words("reserved.types")));
        return words;
    }

    /** The name of an attribute of a class. */
    public String attribute(Type.ClassType type, int index) {
        return attributes.computeIfAbsent(type, this::attributes).get(index);
    }

    private List<String> attributes(Type.ClassType type) {
        UniqueNames scope = language.unreserved();
        return type.attributes().stream()
                .map(a -> scope.claim(NameForms.identifier(a.name())))
                .toList();
    }

    /** The names of an enum's constants, by position. */
    public EnumConstant constant(Type.EnumType type, int ordinal) {
        return Objects.requireNonNull(
                constants.computeIfAbsent(type, this::constants).get(ordinal));
    }

    private Map<Integer, EnumConstant> constants(Type.EnumType type) {
        UniqueNames objects = language.unreserved("reserved.constants");
        UniqueNames codes = language.unreserved();
        codes.claim("SILENCE");
        Map<Integer, EnumConstant> names = new HashMap<>();
        for (String constant : type.constants()) {
            String object = objects.claim(NameForms.identifier(constant));
            String code = codes.claim(NameForms.constant(constant));
            names.put(names.size(), new EnumConstant(object, code));
        }
        return names;
    }
}
