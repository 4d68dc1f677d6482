package arcomat.analysis.engine;

import arcomat.analysis.Budget;
import arcomat.analysis.GivenUp;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Attention;
import arcomat.semantics.Output;
import arcomat.semantics.Sent;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * A side whose reactions are expected some slices later than it sends them; before the first one,
 * anything may be sent. It reads each letter as many slices later, and holds those that it has not
 * read yet. Only for the right side of a comparison.
 */
public final class LateSide implements Side {
    /** With more, there would be too many rows of letters that are held. */
    private static final int MOST_LETTERS = 1_000;

    private final Side side;
    private final int slices;
    private final Focus focus;
    private final int[] positions;
    private final int open;
    private final Output openWhole;

    private final Numbering<State> states = new Numbering<>();
    private final List<KnownSteps> steps = new ArrayList<>();
    private final Map<Long, Value[]> letters = new HashMap<>();

    /**
     * @param inner a configuration of the side
     * @param held the kinds of the letters that it will read, the oldest first
     */
    private record State(int inner, List<Long> held) {}

    /**
     * @param side works in slices
     * @param slices at least 1
     * @param observed how many output ports are compared
     * @throws TooManyMessages where there are too many letters to hold
     * @throws GivenUp where the budget does not suffice to explore the side
     */
    public LateSide(Side side, int slices, int observed, Outputs outputs, Budget budget) {
        this.side = side;
        this.slices = slices;
        this.positions = IntStream.range(0, side.inputs().size()).toArray();
        this.focus = new Focus(0, everything(budget), side.inputs());
        this.open = outputs.number(anything(observed));
        this.openWhole = anything(side.outputs().size());
    }

    private static Output anything(int ports) {
        return new Output(Collections.nCopies(ports, new Sent.Anything()));
    }

    /** Whatever a letter that is held may be looked at for, in whichever configuration. */
    private Attention everything(Budget budget) {
        Attention all = Attention.none(side.inputs().size());
        Numbering<Integer> met = new Numbering<>();
        IntStream.of(side.openings().next()).forEach(met::number);
        for (int i = 0; i < met.size(); i++) {
            String exhausted = budget.exhausted(met.size());
            if (exhausted != null) {
                throw new GivenUp(exhausted);
            }
            int configuration = met.get(i);
            Focus own = side.focus(configuration);
            all = all.and(own.attention());
            for (Value[] letter : letters(own.attention())) {
                budget.insist();
                long kind = own.kind(letter, positions);
                IntStream.of(side.steps(configuration, kind, letter).next()).forEach(met::number);
            }
        }
        letters(all); // to be told that there are too many
        return all;
    }

    private List<Value[]> letters(Attention attention) {
        return Letters.atMost(MOST_LETTERS, side.inputs(), attention.looks());
    }

    @Override
    public Component.Profile profile() {
        return side.profile();
    }

    @Override
    public List<Port> inputs() {
        return side.inputs();
    }

    @Override
    public List<Port> outputs() {
        return side.outputs();
    }

    @Override
    public Steps openings() {
        StepCollector collector = new StepCollector();
        for (int inner : side.openings().next()) {
            collector.add(open, number(new State(inner, List.of())), List.of(), openWhole);
        }
        return collector.steps();
    }

    @Override
    public Focus focus(int configuration) {
        return focus;
    }

    @Override
    public Steps steps(int configuration, long kind, Value[] letter) {
        KnownSteps known = steps.get(configuration);
        Steps found = known.find(kind);
        return found != null ? found : known.add(kind, compute(configuration, kind, letter));
    }

    private Steps compute(int configuration, long kind, Value[] letter) {
        letters.putIfAbsent(kind, letter.clone());
        State before = states.get(configuration);
        List<Long> held = new ArrayList<>(before.held);
        held.add(kind);
        if (held.size() <= slices) {
            return waiting(before.inner, held);
        }
        Value[] oldest = letters.get(held.remove(0));
        long own = side.focus(before.inner).kind(oldest, positions);
        return reading(side.steps(before.inner, own, oldest), held);
    }

    private Steps waiting(int inner, List<Long> held) {
        StepCollector collector = new StepCollector();
        collector.add(open, number(new State(inner, held)), List.of(), openWhole);
        return collector.steps();
    }

    private Steps reading(Steps own, List<Long> held) {
        int[] next =
                IntStream.of(own.next()).map(inner -> number(new State(inner, held))).toArray();
        boolean[] used = new boolean[own.size()];
        return new Steps(own.outputs(), next, own.causes(), own.whole(), used, List.of(own));
    }

    private int number(State state) {
        int number = states.number(state);
        if (number == steps.size()) {
            steps.add(new KnownSteps());
        }
        return number;
    }

    @Override
    public boolean isChaos(int configuration) {
        return side.isChaos(states.get(configuration).inner);
    }

    @Override
    public boolean mayErr() {
        return side.mayErr();
    }

    @Override
    public String describe(int configuration) {
        return side.describe(states.get(configuration).inner);
    }

    @Override
    public String name(int configuration) {
        State state = states.get(configuration);
        return side.name(state.inner) + " holds " + state.held;
    }

    @Override
    public Set<Trace.Cause> used() {
        return side.used();
    }

    @Override
    public Optional<String> leftOut() {
        return side.leftOut();
    }

    @Override
    public int size() {
        return states.size();
    }
}
