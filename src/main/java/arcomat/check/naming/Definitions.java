package arcomat.check.naming;

import arcomat.tree.Automaton;
import arcomat.tree.Definition;
import arcomat.tree.Name;
import arcomat.tree.Node;
import arcomat.tree.Unit;

import java.util.Optional;

/** What files define, and under which name. */
public final class Definitions {
    private Definitions() {}

    /** The name of a definition; a bare automaton may have none. */
    public static Optional<Name> name(Definition definition) {
        return definition.match(
                new Definition.Cases<>(
                        component -> Optional.of(component.name()),
                        Automaton::name,
                        diagram -> Optional.of(diagram.name()),
                        suite -> Optional.of(suite.name())));
    }

    /** Where to point at for a finding about a whole file. */
    static Node nameOf(Unit unit) {
        Optional<Name> name = name(unit.definition());
        return name.isPresent() ? name.get() : unit.definition();
    }
}
