package arcomat.check.law;

import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.tree.TypeReference;
import arcomat.tree.Unit;

import java.util.Optional;

/**
 * Where the walk is.
 *
 * @param component the innermost component around the thing; empty in files about other things
 * @param automaton the automaton around it
 * @param transition the transition around it
 * @param side the side of the block or of the table row around it
 */
public record Context(
        Workspace workspace,
        Profile profile,
        Unit unit,
        Optional<ComponentSymbol> component,
        Optional<AutomatonSymbol> automaton,
        Optional<TransitionSymbol> transition,
        Optional<ItemSymbol.Side> side) {

    public static Context of(Workspace workspace, Profile profile, Unit unit) {
        return new Context(
                workspace,
                profile,
                unit,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    public Context in(ComponentSymbol inner) {
        return new Context(
                workspace, profile, unit, Optional.of(inner), automaton, transition, side);
    }

    public Context in(AutomatonSymbol inner) {
        return new Context(
                workspace, profile, unit, component, Optional.of(inner), transition, side);
    }

    public Context in(TransitionSymbol inner) {
        return new Context(
                workspace, profile, unit, component, automaton, Optional.of(inner), side);
    }

    public Context in(ItemSymbol.Side inner) {
        return new Context(
                workspace, profile, unit, component, automaton, transition, Optional.of(inner));
    }

    /** What the names of the file reach. */
    public UnitScope scope() {
        return workspace.scope(unit);
    }

    /** What a message type means here: type parameters of the component come first. */
    public Resolution<TypeSymbol> resolve(TypeReference type) {
        return component.isPresent() ? component.get().resolveType(type) : scope().type(type);
    }
}
