package arcomat.analysis.search.system;

import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * A system whose reactions on some ports stand in the slice in which they are seen, one after that
 * in which they are made. Two systems can be compared where one sends with delay and the other one
 * without. Where a run ends, what was sent a slice ago is still seen.
 *
 * <p>Remembers what will be seen in the next slice on those ports.
 */
public final class ShiftedSystem extends HistorySystem<List<Sent>> {
    private final BitSet late;
    private final List<Port> observed;
    private final OutputCubes outputs;

    private ShiftedSystem(
            TransitionSystem system, BitSet late, List<Port> observed, OutputCubes outputs) {
        super(system);
        this.late = late;
        this.observed = List.copyOf(observed);
        this.outputs = outputs;
    }

    /**
     * The system as it is seen beside another one; itself where both send with the same delays.
     *
     * @param observed the compared ports
     */
    public static TransitionSystem beside(
            TransitionSystem system,
            TransitionSystem other,
            List<Port> observed,
            OutputCubes outputs) {
        BitSet late = new BitSet();
        int[] own = system.delays();
        int[] others = other.delays();
        for (int port = 0; port < own.length; port++) {
            late.set(port, own[port] == 1 && others[port] == 0);
        }
        return late.isEmpty() ? system : new ShiftedSystem(system, late, observed, outputs);
    }

    /** The compared ports that stand in the slice in which they are seen. */
    public BitSet late() {
        return (BitSet) late.clone();
    }

    @Override
    public int[] delays() {
        int[] delays = super.delays();
        late.stream().forEach(port -> delays[port] = 0);
        return delays;
    }

    @Override
    public Steps openings() {
        return shown(system.openings(), silence());
    }

    @Override
    public LetterClasses letterClasses(int configuration) {
        return system.letterClasses(get(configuration).inner());
    }

    /** What is going to be seen is remembered, and what is remembered is seen. */
    @Override
    public Optional<List<DataStep>> dataSteps(int configuration) {
        List<Port> ports = late.stream().mapToObj(observed::get).toList();
        List<Sent> memory = get(configuration).memory();
        List<List<Value>> messages =
                late.stream().mapToObj(memory::get).map(ShiftedSystem::messages).toList();
        DataStep seen = DataStep.sending(ports, messages);
        return system.dataSteps(get(configuration).inner())
                .map(
                        steps ->
                                Stream.concat(
                                                Stream.of(seen),
                                                steps.stream().map(each -> each.remembering(ports)))
                                        .toList());
    }

    @Override
    Steps compute(State<List<Sent>> before, long kind, Value[] letter) {
        return shown(system.steps(before.inner(), letter), before.memory());
    }

    private Steps shown(Steps own, List<Sent> seen) {
        int[] sent = new int[own.size()];
        int[] next = new int[own.size()];
        for (int step = 0; step < sent.length; step++) {
            boolean letter = outputs.isLetter(own.outputs()[step]);
            List<Sent> made = letter ? outputs.letter(own.outputs()[step]).ports() : silence();
            Output both = new Output(replaced(made, seen));
            sent[step] = letter ? outputs.number(both) : outputs.end(both);
            next[step] = number(own.next()[step], replaced(silence(), made));
        }
        return own.changed(sent, next);
    }

    private static List<Value> messages(Sent sent) {
        return sent instanceof Sent.Messages messages ? messages.values() : List.of();
    }

    private List<Sent> silence() {
        return Collections.nCopies(observed.size(), Sent.SILENCE);
    }

    /** On late ports those of the second list. */
    private List<Sent> replaced(List<Sent> one, List<Sent> other) {
        List<Sent> both = new ArrayList<>(one);
        late.stream().forEach(port -> both.set(port, other.get(port)));
        return both;
    }

    /** What is going to be seen has to be open, too. */
    @Override
    public boolean isChaos(int configuration) {
        List<Sent> memory = get(configuration).memory();
        return super.isChaos(configuration)
                && late.stream()
                        .allMatch(port -> isOpen(memory.get(port), observed.get(port).total()));
    }

    private static boolean isOpen(Sent sent, boolean total) {
        return sent instanceof Sent.Anything || total && sent instanceof Sent.AnyMessage;
    }

    @Override
    public boolean postpones() {
        return super.postpones() || IntStream.range(0, size()).anyMatch(this::isOpen);
    }

    private boolean isOpen(int configuration) {
        List<Sent> memory = get(configuration).memory();
        return late.stream().anyMatch(port -> !(memory.get(port) instanceof Sent.Messages));
    }

    @Override
    void tell(List<Sent> memory, DataPlaces data, DataPlaces.Holding holding) {
        late.stream().forEach(port -> holding.values(memory.get(port), data.outputs().get(port)));
    }

    @Override
    String words(List<Sent> memory) {
        return memory.toString();
    }
}
