package arcomat.analysis.mona;

import arcomat.analysis.mona.Bits.Condition;
import arcomat.analysis.mona.MonaFormula.SystemText;
import arcomat.analysis.mona.MonaFormula.TrackText;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.letter.Letters;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.system.AutomataSystem;
import arcomat.analysis.search.system.ShiftedSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Port;
import arcomat.semantics.automaton.ComponentSemantics;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Whether all runs of one side are runs of the other, spelled out: all steps of both, and the ports
 * that they share in binary. A position of a string is a slice: inputs stand where they are read,
 * outputs where they are seen, states before the step.
 *
 * @param inputs those of the left side
 * @param observed the output ports of the right side
 * @param rights one per automaton of the right side
 * @param delays per observed port the slices after which a reaction is seen; where only one of both
 *     sides sends with delay, its machine sends when it is seen, and both have none
 * @param mixed the observed ports of which that is so
 */
public record InclusionProblem(
        String rightTitle,
        List<Port> leftOutputs,
        List<PortTrack> inputs,
        List<PortTrack> observed,
        ExplicitSystem left,
        List<ExplicitSystem> rights,
        List<Integer> delays,
        BitSet mixed) {

    /** A question that is not put to MONA; the message says why. */
    public static final class NotForMona extends RuntimeException {
        private static final long serialVersionUID = 1L;

        public NotForMona(String reason) {
            super(reason);
        }
    }

    /** A side with its name. */
    public record Named(String title, ComponentSemantics behaviour) {}

    /**
     * @param rights one per automaton of the right side, of one component, whose ports the left
     *     side has, too
     * @throws NotForMona where a type is not finite, or a side is too large
     */
    public static InclusionProblem of(
            Named left, String rightTitle, List<Named> rights, Budget budget) {
        List<Port> ports = rights.get(0).behaviour().component().outputs();
        Map<String, PortTrack> inputs = new LinkedHashMap<>();
        Letters.compared(
                        left.behaviour().component().inputs(),
                        rights.get(0).behaviour().component().inputs())
                .forEach(port -> inputs.put(port.name(), PortTrack.of(port)));
        Spelling spelling = new Spelling(ports, inputs, new OutputCubes(), budget);
        TransitionSystem mine = spelling.side(left);
        List<ExplicitSystem> theirs = new ArrayList<>();
        for (Named right : rights) {
            theirs.add(spelling.machine(right, spelling.beside(spelling.side(right), mine)));
        }
        TransitionSystem other = spelling.side(rights.get(0));
        TransitionSystem shown = spelling.beside(mine, other);
        BitSet mixed = mixed(mine.delays(), other.delays());
        return new InclusionProblem(
                rightTitle,
                left.behaviour().component().outputs(),
                List.copyOf(inputs.values()),
                ports.stream().map(PortTrack::of).toList(),
                spelling.machine(left, shown),
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
    private record Spelling(
            List<Port> observed,
            Map<String, PortTrack> inputs,
            OutputCubes outputs,
            Budget budget) {
        TransitionSystem side(Named named) {
            List<String> names = observed.stream().map(Port::name).toList();
            return new AutomataSystem(named.behaviour(), names, outputs, budget);
        }

        TransitionSystem beside(TransitionSystem side, TransitionSystem other) {
            return ShiftedSystem.beside(side, other, observed, outputs);
        }

        ExplicitSystem machine(Named named, TransitionSystem side) {
            List<PortTrack> own =
                    side.inputs().stream().map(port -> inputs.get(port.name())).toList();
            try {
                return ExplicitSystem.explore(named.title(), side, own, outputs, budget);
            } catch (NotForMona problem) {
                throw new NotForMona(named.title() + ": " + problem.getMessage());
            }
        }
    }

    /** What a template needs to write it: with bits at positions what ports and sides do. */
    public MonaFormula formula() {
        List<TrackText> tracks = new ArrayList<>();
        List<Condition> valid = new ArrayList<>();
        Stream.concat(inputs.stream(), observed.stream())
                .forEach(
                        track -> {
                            tracks.add(new TrackText(track.legend(), track.bits().names()));
                            valid.addAll(track.valid(SystemWriter.NOW));
                        });
        List<SystemText> texts = new ArrayList<>();
        for (int i = 0; i < rights.size(); i++) {
            String name = rights.size() == 1 ? "right" : "right" + (i + 1);
            texts.add(new SystemWriter(this, rights.get(i), name, true).text());
        }
        // A counterexample shows the states of the left side; so they are not hidden.
        SystemText mine = new SystemWriter(this, left, "left", false).text();
        return new MonaFormula(left.title(), rightTitle, tracks, valid, fails(), mine, texts);
    }

    public int leftStates() {
        return left.states().size();
    }

    /** Those of all automata of the right side. */
    public int rightStates() {
        return rights.stream().mapToInt(right -> right.states().size()).sum();
    }

    /** Whether some run ends with an error. */
    boolean fails() {
        return left.mayFail() || rights.stream().anyMatch(ExplicitSystem::mayFail);
    }
}
