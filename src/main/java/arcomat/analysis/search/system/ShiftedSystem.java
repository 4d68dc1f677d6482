package arcomat.analysis.search.system;

import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A system whose reactions on some ports stand in the slice in which they are seen, one after that
 * in which they are made. Two systems can be compared where one sends with delay and the other one
 * without. Where a run ends, what was sent a slice ago is still seen.
 *
 * <p>Remembers what will be seen in the next slice on those ports.
 */
public final class ShiftedSystem extends HistorySystem<List<Sent>> {
    private final BitSet late;
    private final int observed;
    private final OutputCubes outputs;
    private final List<Boolean> total;

    private ShiftedSystem(
            TransitionSystem system, BitSet late, List<Boolean> total, OutputCubes outputs) {
        super(system);
        this.late = late;
        this.observed = total.size();
        this.total = total;
        this.outputs = outputs;
    }

    /**
     * The system as it is seen beside another one; itself where both send with the same delays.
     *
     * @param total per compared port, whether it carries a message in every slice
     */
    public static TransitionSystem beside(
            TransitionSystem system,
            TransitionSystem other,
            List<Boolean> total,
            OutputCubes outputs) {
        BitSet late = new BitSet();
        int[] own = system.delays();
        int[] others = other.delays();
        for (int port = 0; port < own.length; port++) {
            late.set(port, own[port] == 1 && others[port] == 0);
        }
        return late.isEmpty() ? system : new ShiftedSystem(system, late, total, outputs);
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

    private List<Sent> silence() {
        return Collections.nCopies(observed, Sent.SILENCE);
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
                && late.stream().allMatch(port -> isOpen(memory.get(port), total.get(port)));
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
