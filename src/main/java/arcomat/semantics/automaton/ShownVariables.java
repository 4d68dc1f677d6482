package arcomat.semantics.automaton;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Variable;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.Effect;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Puts the values of an automaton's variables after a step on the ports that show them. Of ports
 * that show those of other automata it says nothing.
 */
final class ShownVariables {
    private static final ShownVariables NONE = new ShownVariables();

    /**
     * @param port its position among the outputs
     * @param slot of the variable; -1 where another automaton has it
     */
    private record Window(int port, int slot, String name, Sent anything) {}

    private final List<Window> windows = new ArrayList<>();

    private ShownVariables() {}

    static ShownVariables of(Component component, Automaton automaton) {
        if (!(component.body() instanceof Component.Atomic atomic) || atomic.shown().isEmpty()) {
            return NONE;
        }
        List<String> variables = automaton.variables().stream().map(Variable::name).toList();
        List<Port> outputs = component.outputs();
        ShownVariables all = new ShownVariables();
        for (Component.Shown shown : atomic.shown()) {
            for (int port = 0; port < outputs.size(); port++) {
                if (outputs.get(port).name().equals(shown.port())) {
                    all.windows.add(
                            new Window(
                                    port,
                                    variables.indexOf(shown.variable()),
                                    shown.port(),
                                    Effect.anything(outputs.get(port))));
                }
            }
        }
        return all;
    }

    /** The reaction with what can be seen of the configuration that it leads to. */
    Reaction in(Reaction reaction) {
        if (windows.isEmpty()) {
            return reaction;
        }
        List<Sent> sent = new ArrayList<>(reaction.output().ports());
        for (Window window : windows) {
            boolean known = window.slot >= 0 && reaction.next().isState();
            sent.set(
                    window.port,
                    known ? Sent.of(reaction.next().slots()[window.slot]) : window.anything);
        }
        return new Reaction(reaction.cause(), new Output(sent), reaction.next());
    }

    /** What a variable holds, gets to the port. */
    void tellFlow(DataSorts sorts, Map<String, Integer> ports, int[] variables) {
        for (Window window : windows) {
            if (window.slot >= 0) {
                int port = Objects.requireNonNull(ports.get(window.name));
                sorts.join(port, variables[window.slot]);
            }
        }
    }
}
