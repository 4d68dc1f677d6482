package arcomat.check.naming;

import arcomat.tree.Automaton;
import arcomat.tree.ClassDiagram;
import arcomat.tree.Component;
import arcomat.tree.Definition;
import arcomat.tree.Name;
import arcomat.tree.Node;
import arcomat.tree.TestSuite;
import arcomat.tree.Unit;

import java.util.Optional;

/** What files define, and under which name. */
public final class Definitions {
    private Definitions() {}

    /** The name of a definition; a bare automaton may have none. */
    static Optional<Name> name(Definition definition) {
        if (definition instanceof Component component) {
            return Optional.of(component.name());
        }
        if (definition instanceof ClassDiagram diagram) {
            return Optional.of(diagram.name());
        }
        if (definition instanceof TestSuite suite) {
            return Optional.of(suite.name());
        }
        if (definition instanceof Automaton automaton) {
            return automaton.name();
        }
        throw new AssertionError(definition);
    }

    /** Where to point at for a finding about a whole file. */
    static Node nameOf(Unit unit) {
        Optional<Name> name = name(unit.definition());
        return name.isPresent() ? name.get() : unit.definition();
    }
}
