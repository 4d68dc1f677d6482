package arcomat.analysis.engine;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Attention;
import arcomat.semantics.Attention.Look;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * A side as its surroundings really drive it: a latched port that has got a message holds one from
 * then on. Letters in which it is empty again cannot happen, and have no steps. Only for the left
 * side of a comparison; the right one then meets no other letters.
 */
public final class HeldInputs implements Side {
    private final Side side;
    private final List<Port> inputs;
    private final int[] positions;
    private final List<Integer> latched;

    private final Numbering<State> states = new Numbering<>();
    private final Map<Attention, Focus> foci = new HashMap<>();
    private final List<KnownSteps> steps = new ArrayList<>();

    /**
     * @param inner a configuration of the side
     * @param held a bit for each latched port that holds something
     */
    private record State(int inner, long held) {}

    private HeldInputs(Side side) {
        this.side = side;
        this.inputs = side.inputs();
        this.positions = IntStream.range(0, inputs.size()).toArray();
        this.latched =
                IntStream.of(positions).filter(i -> inputs.get(i).latched()).boxed().toList();
    }

    /** The side itself if it has no latched ports. */
    public static Side of(Side side) {
        HeldInputs driven = new HeldInputs(side);
        boolean any = !driven.latched.isEmpty() && driven.latched.size() < Long.SIZE;
        return any && side.profile() == Component.Profile.EVENT_DRIVEN ? driven : side;
    }

    @Override
    public Component.Profile profile() {
        return side.profile();
    }

    @Override
    public List<Port> inputs() {
        return inputs;
    }

    @Override
    public List<Port> outputs() {
        return side.outputs();
    }

    @Override
    public Steps openings() {
        return holding(side.openings(), 0);
    }

    /** Of a latched port it always matters whether it holds something. */
    @Override
    public Focus focus(int configuration) {
        List<Look> looks =
                new ArrayList<>(side.focus(states.get(configuration).inner).attention().looks());
        for (int port : latched) {
            looks.set(port, looks.get(port).and(new Attention.Compared(List.of(), false)));
        }
        return foci.computeIfAbsent(
                new Attention(looks), each -> new Focus(foci.size(), each, inputs));
    }

    @Override
    public Steps steps(int configuration, long kind, Value[] letter) {
        KnownSteps known = steps.get(configuration);
        Steps found = known.find(kind);
        return found != null ? found : known.add(kind, compute(configuration, letter));
    }

    private Steps compute(int configuration, Value[] letter) {
        long before = states.get(configuration).held;
        long now = 0;
        for (int i = 0; i < latched.size(); i++) {
            now |= letter[latched.get(i)] == null ? 0 : 1L << i;
        }
        if ((before & ~now) != 0) {
            return new StepCollector().steps();
        }
        int own = states.get(configuration).inner;
        return holding(side.steps(own, side.focus(own).kind(letter, positions), letter), now);
    }

    private Steps holding(Steps own, long now) {
        int[] next = IntStream.of(own.next()).map(each -> number(new State(each, now))).toArray();
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
        long bits = states.get(configuration).held;
        return side.name(states.get(configuration).inner)
                + (bits == 0 ? "" : " holds " + Long.toBinaryString(bits));
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
