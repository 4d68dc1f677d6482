package arcomat.symbols.names;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Types in place of type parameters. */
public record TypeSubstitution(Map<TypeVariable, TypeSymbol> arguments) {
    public static final TypeSubstitution NONE = new TypeSubstitution(Map.of());

    public TypeSubstitution {
        arguments = Map.copyOf(arguments);
    }

    /** A missing argument leaves an unknown type, a superfluous one is ignored. */
    public static TypeSubstitution of(List<TypeVariable> parameters, List<TypeSymbol> arguments) {
        if (parameters.isEmpty()) {
            return NONE;
        }
        Map<TypeVariable, TypeSymbol> map = new HashMap<>();
        for (int i = 0; i < parameters.size(); i++) {
            map.put(
                    parameters.get(i),
                    i < arguments.size() ? arguments.get(i) : UnknownType.UNKNOWN);
        }
        return new TypeSubstitution(map);
    }

    public TypeSymbol apply(TypeSymbol type) {
        if (type instanceof JavaType java && !arguments.isEmpty()) {
            return new JavaType(
                    java.qualifiedName(),
                    java.arguments().stream()
                            .map(each -> new JavaType.Argument(each.bound(), apply(each.type())))
                            .toList());
        }
        return type instanceof TypeVariable variable
                ? arguments.getOrDefault(variable, variable)
                : type;
    }

    /** First this one, then another. */
    public TypeSubstitution then(TypeSubstitution next) {
        if (arguments.isEmpty()) {
            return next;
        }
        Map<TypeVariable, TypeSymbol> map = new HashMap<>(next.arguments);
        arguments.forEach((variable, type) -> map.put(variable, next.apply(type)));
        return new TypeSubstitution(map);
    }

    /** This one, and what another says about further parameters. */
    public TypeSubstitution and(TypeSubstitution other) {
        if (other.arguments.isEmpty()) {
            return this;
        }
        Map<TypeVariable, TypeSymbol> map = new HashMap<>(other.arguments);
        map.putAll(arguments);
        return new TypeSubstitution(map);
    }

    /** What it says about some parameters. */
    public TypeSubstitution only(List<TypeVariable> parameters) {
        Map<TypeVariable, TypeSymbol> map = new HashMap<>();
        for (TypeVariable parameter : parameters) {
            if (arguments.containsKey(parameter)) {
                map.put(parameter, arguments.get(parameter));
            }
        }
        return map.isEmpty() ? NONE : new TypeSubstitution(map);
    }
}
