package arcomat.analysis.search.system;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.letter.Letters;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.GivenUp;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.TooManyMessages;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.IntStream;

/**
 * A system whose reactions are expected some slices later than it sends them; before the first one,
 * anything may be sent. It reads each letter as many slices later, and holds those that it has not
 * read yet. Only for the right side of a comparison.
 *
 * <p>Remembers the kinds of the letters that it will read, the oldest first.
 */
public final class DelayedSystem extends HistorySystem<List<Long>> {
    /** With more, there would be too many rows of letters that are held. */
    private static final int MOST_LETTERS = 1_000;

    private final int slices;
    private final LetterClasses classes;
    private final int open;
    private final Output openWhole;
    private final Map<Long, Value[]> letters = new HashMap<>();

    private DelayedSystem(
            TransitionSystem system,
            int slices,
            LetterClasses classes,
            int observed,
            OutputCubes outputs) {
        super(system);
        this.slices = slices;
        this.classes = classes;
        this.open = outputs.number(anything(observed));
        this.openWhole = anything(system.outputs().size());
    }

    /**
     * @param system works in slices
     * @param slices at least 1
     * @param observed how many output ports are compared
     * @throws TooManyMessages where there are too many letters to hold
     * @throws GivenUp where the budget does not suffice to explore the system
     */
    public static DelayedSystem of(
            TransitionSystem system, int slices, int observed, OutputCubes outputs, Budget budget) {
        LetterClasses classes = new LetterClasses(0, everything(system, budget), system.inputs());
        return new DelayedSystem(system, slices, classes, observed, outputs);
    }

    private static Output anything(int ports) {
        return new Output(Collections.nCopies(ports, new Sent.Anything()));
    }

    /** Whatever a letter that is held may be looked at for, in whichever configuration. */
    private static InputAbstraction everything(TransitionSystem system, Budget budget) {
        InputAbstraction all = InputAbstraction.none(system.inputs().size());
        Numbering<Integer> met = new Numbering<>();
        IntStream.of(system.openings().next()).forEach(met::number);
        for (int i = 0; i < met.size(); i++) {
            String exhausted = budget.exhausted(met.size());
            if (exhausted != null) {
                throw new GivenUp(exhausted);
            }
            int configuration = met.get(i);
            InputAbstraction abstraction = system.letterClasses(configuration).abstraction();
            all = all.and(abstraction);
            for (Value[] letter : letters(system, abstraction)) {
                budget.insist();
                IntStream.of(system.steps(configuration, letter).next()).forEach(met::number);
            }
        }
        letters(system, all); // to be told that there are too many
        return all;
    }

    private static List<Value[]> letters(TransitionSystem system, InputAbstraction abstraction) {
        return Letters.atMost(MOST_LETTERS, system.inputs(), abstraction.looks());
    }

    @Override
    public Steps openings() {
        return waiting(system.openings().next(), List.of());
    }

    @Override
    public LetterClasses letterClasses(int configuration) {
        return classes;
    }

    @Override
    Steps compute(State<List<Long>> before, long kind, Value[] letter) {
        letters.putIfAbsent(kind, letter);
        List<Long> held = new ArrayList<>(before.memory());
        held.add(kind);
        if (held.size() <= slices) {
            return waiting(new int[] {before.inner()}, held);
        }
        Value[] oldest = Objects.requireNonNull(letters.get(held.remove(0)));
        return remembering(system.steps(before.inner(), oldest), held);
    }

    /** Anything may be sent. */
    private Steps waiting(int[] inner, List<Long> held) {
        Steps.Collector collector = new Steps.Collector();
        for (int each : inner) {
            collector.add(open, number(each, held), List.of(), openWhole);
        }
        return collector.steps();
    }

    @Override
    void tell(List<Long> kinds, DataPlaces data, DataPlaces.Holding holding) {
        for (long kind : kinds) {
            Value[] letter = Objects.requireNonNull(letters.get(kind));
            for (int i = 0; i < letter.length; i++) {
                if (letter[i] != null) {
                    holding.value(data.input(system.inputs().get(i).name()), letter[i]);
                }
            }
        }
    }

    @Override
    String words(List<Long> held) {
        return held.toString();
    }
}
