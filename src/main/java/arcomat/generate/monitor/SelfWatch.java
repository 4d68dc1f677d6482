package arcomat.generate.monitor;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Value;

import java.util.List;

/**
 * A requirement that a program watches itself for.
 *
 * @param program the component that the program runs
 * @param part path of the part whose ports are watched; empty for the component itself
 * @param running the component of that part
 * @param required the component that has the requirement; it has no ports but those of the part
 * @param arguments one per parameter of that component
 */
public record SelfWatch(
        Component program,
        String part,
        Component running,
        Component required,
        Automaton automaton,
        List<Value> arguments) {
    public SelfWatch {
        arguments = List.copyOf(arguments);
    }

    /** Whether the robot goes on after a violation. */
    public boolean goesOn() {
        return automaton.violated() == Automaton.Violated.CONTINUE;
    }
}
