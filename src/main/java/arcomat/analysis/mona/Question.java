package arcomat.analysis.mona;

import arcomat.analysis.Budget;
import arcomat.analysis.engine.AtomicSide;
import arcomat.analysis.engine.Outputs;
import arcomat.model.Port;
import arcomat.semantics.Behaviour;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Does one side refine the other, spelled out: all steps of both, and the ports that they share in
 * binary. A position of a string is a slice: inputs stand where they are read, outputs where they
 * are seen, states before the step.
 *
 * @param inputs those of the left side
 * @param observed the output ports of the right side
 * @param rights one per automaton of the right side
 */
public record Question(
        String leftTitle,
        String rightTitle,
        List<String> rightTitles,
        List<Port> leftOutputs,
        List<Track> inputs,
        List<Track> observed,
        Machine left,
        List<Machine> rights) {

    /** A side with its name. */
    public record Named(String title, Behaviour behaviour) {}

    /**
     * @param rights one per automaton of the right side, of one component, whose ports the left
     *     side has, too
     * @throws NotForMona where a type is not finite, or a side is too large
     */
    public static Question of(Named left, String rightTitle, List<Named> rights, Budget budget) {
        List<Port> ports = rights.get(0).behaviour().component().outputs();
        List<String> names = ports.stream().map(Port::name).toList();
        Map<String, Track> inputs = new LinkedHashMap<>();
        left.behaviour().component().inputs().forEach(p -> inputs.put(p.name(), Track.of(p)));
        List<Machine> machines = new ArrayList<>();
        for (Named right : rights) {
            machines.add(machine(right, names, inputs, budget));
        }
        return new Question(
                left.title(),
                rightTitle,
                rights.stream().map(Named::title).toList(),
                left.behaviour().component().outputs(),
                List.copyOf(inputs.values()),
                ports.stream().map(Track::of).toList(),
                machine(left, names, inputs, budget),
                machines);
    }

    private static Machine machine(
            Named named, List<String> observed, Map<String, Track> inputs, Budget budget) {
        Outputs outputs = new Outputs();
        AtomicSide side = new AtomicSide(named.behaviour(), observed, outputs, budget);
        List<Track> own = side.inputs().stream().map(port -> inputs.get(port.name())).toList();
        try {
            return Machine.explore(side, own, outputs, budget);
        } catch (NotForMona problem) {
            throw new NotForMona(named.title() + ": " + problem.getMessage());
        }
    }

    /** What a template needs to write it. */
    public Formula formula() {
        return new FormulaWriter(this).formula();
    }

    public int leftStates() {
        return left.states().size();
    }

    /** Those of all automata of the right side. */
    public int rightStates() {
        return rights.stream().mapToInt(right -> right.states().size()).sum();
    }

    /** Inputs, then compared outputs. */
    List<Track> tracks() {
        return Stream.concat(inputs.stream(), observed.stream()).toList();
    }

    /** Whether some run ends with an error. */
    boolean fails() {
        return left.mayFail() || rights.stream().anyMatch(Machine::mayFail);
    }

    static Bits stateBits(String machine, Machine of) {
        return Bits.named(machine + "State", of.states().size());
    }
}
