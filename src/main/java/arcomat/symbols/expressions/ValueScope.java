package arcomat.symbols.expressions;

import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.tree.TypeReference;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * The values that an expression at some place may name. Inner scopes hide outer ones; among
 * duplicates the first declaration counts.
 */
public final class ValueScope {
    private final UnitScope unitScope;
    private final Function<TypeReference, Resolution<TypeSymbol>> types;
    private final Optional<ValueScope> outer;
    private final Map<String, ValueSymbol> values = new HashMap<>();

    /** Those of outer scopes included: names are looked up more often than scopes are made. */
    private final Map<String, ValueSymbol> reached = new HashMap<>();

    private ValueScope(
            UnitScope unitScope,
            Function<TypeReference, Resolution<TypeSymbol>> types,
            Optional<ValueScope> outer,
            Collection<? extends ValueSymbol> values) {
        this.unitScope = unitScope;
        this.types = types;
        this.outer = outer;
        values.forEach(v -> this.values.putIfAbsent(v.name(), v));
        outer.ifPresent(scope -> reached.putAll(scope.reached));
        reached.putAll(this.values);
    }

    /** A scope in which only constants of enumerations can be named. */
    public static ValueScope empty(
            UnitScope unitScope, Function<TypeReference, Resolution<TypeSymbol>> types) {
        return new ValueScope(unitScope, types, Optional.empty(), Set.of());
    }

    public ValueScope with(Collection<? extends ValueSymbol> inner) {
        return new ValueScope(unitScope, types, Optional.of(this), inner);
    }

    /** What a simple name means here. */
    public Optional<ValueSymbol> value(String name) {
        return Optional.ofNullable(reached.get(name));
    }

    /** All names, inner ones first: to suggest the nearest. */
    public Set<String> names() {
        Set<String> names = new LinkedHashSet<>(values.keySet());
        outer.ifPresent(scope -> names.addAll(scope.names()));
        return names;
    }

    UnitScope unitScope() {
        return unitScope;
    }

    public Resolution<TypeSymbol> type(TypeReference reference) {
        return types.apply(reference);
    }
}
