package arcomat.analysis.mona;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Letters;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.system.AutomataSystem;
import arcomat.analysis.search.system.ShiftedSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Port;
import arcomat.semantics.automaton.Behaviour;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Does one side refine the other, spelled out: all steps of both, and the ports that they share in
 * binary. A position of a string is a slice: inputs stand where they are read, outputs where they
 * are seen, states before the step.
 *
 * @param inputs those of the left side
 * @param observed the output ports of the right side
 * @param rights one per automaton of the right side
 * @param delays per observed port the slices after which a reaction is seen; where only one of both
 *     sides sends with delay, its machine sends when it is seen, and both have none
 * @param mixed the observed ports of which that is so
 */
public record Question(
        String leftTitle,
        String rightTitle,
        List<String> rightTitles,
        List<Port> leftOutputs,
        List<Track> inputs,
        List<Track> observed,
        Machine left,
        List<Machine> rights,
        List<Integer> delays,
        BitSet mixed) {

    /** A side with its name. */
    public record Named(String title, Behaviour behaviour) {}

    /**
     * @param rights one per automaton of the right side, of one component, whose ports the left
     *     side has, too
     * @throws NotForMona where a type is not finite, or a side is too large
     */
    public static Question of(Named left, String rightTitle, List<Named> rights, Budget budget) {
        List<Port> ports = rights.get(0).behaviour().component().outputs();
        Map<String, Track> inputs = new LinkedHashMap<>();
        Letters.compared(
                        left.behaviour().component().inputs(),
                        rights.get(0).behaviour().component().inputs())
                .forEach(port -> inputs.put(port.name(), Track.of(port)));
        Machines machines = new Machines(ports, inputs, budget);
        TransitionSystem mine = machines.side(left);
        List<Machine> theirs = new ArrayList<>();
        for (Named right : rights) {
            theirs.add(machines.machine(right, machines.beside(machines.side(right), mine)));
        }
        TransitionSystem other = machines.side(rights.get(0));
        TransitionSystem shown = machines.beside(mine, other);
        BitSet mixed = mixed(mine.delays(), other.delays());
        return new Question(
                left.title(),
                rightTitle,
                rights.stream().map(Named::title).toList(),
                left.behaviour().component().outputs(),
                List.copyOf(inputs.values()),
                ports.stream().map(Track::of).toList(),
                machines.machine(left, shown),
                theirs,
                IntStream.of(shown.delays()).boxed().toList(),
                mixed);
    }

    private static BitSet mixed(int[] mine, int[] theirs) {
        BitSet mixed = new BitSet();
        IntStream.range(0, mine.length).forEach(i -> mixed.set(i, mine[i] != theirs[i]));
        return mixed;
    }

    /** Spells out what is compared on some ports. */
    private record Machines(
            List<Port> observed, Map<String, Track> inputs, OutputCubes outputs, Budget budget) {
        Machines(List<Port> observed, Map<String, Track> inputs, Budget budget) {
            this(observed, inputs, new OutputCubes(), budget);
        }

        TransitionSystem side(Named named) {
            List<String> names = observed.stream().map(Port::name).toList();
            return new AutomataSystem(named.behaviour(), names, outputs, budget);
        }

        TransitionSystem beside(TransitionSystem side, TransitionSystem other) {
            List<Boolean> total = observed.stream().map(Port::total).toList();
            return ShiftedSystem.beside(side, other, total, outputs);
        }

        Machine machine(Named named, TransitionSystem side) {
            List<Track> own = side.inputs().stream().map(port -> inputs.get(port.name())).toList();
            try {
                return Machine.explore(side, own, outputs, budget);
            } catch (NotForMona problem) {
                throw new NotForMona(named.title() + ": " + problem.getMessage());
            }
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
