package arcomat.analysis.search.system;

import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.letter.LatchedPorts;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.InputAbstraction;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;

/**
 * A system as its environment really drives it: a latched port that has got a message holds one
 * from then on. Letters in which it is empty again cannot happen, and have no steps. Only for the
 * left side of a comparison; the right one then meets no other letters.
 *
 * <p>Remembers a bit for each latched port that holds something.
 */
public final class DrivenSystem extends HistorySystem<Long> implements PackableSystem {
    private final LatchedPorts latched;
    private final Map<InputAbstraction, LetterClasses> classes = new HashMap<>();

    private DrivenSystem(TransitionSystem system, LatchedPorts latched) {
        super(system);
        this.latched = latched;
    }

    /** The system itself if it has no latched ports. */
    public static TransitionSystem of(TransitionSystem system) {
        LatchedPorts latched = LatchedPorts.of(system.profile(), system.inputs());
        int count = latched.positions().size();
        return count == 0 || count >= Long.SIZE ? system : new DrivenSystem(system, latched);
    }

    @Override
    public Steps openings() {
        return remembering(system.openings(), 0L);
    }

    /** Of a latched port it always matters whether it holds something. */
    @Override
    public LetterClasses letterClasses(int configuration) {
        InputAbstraction own = system.letterClasses(get(configuration).inner()).abstraction();
        return classes.computeIfAbsent(
                own.and(latched.abstraction(inputs().size())),
                each -> new LetterClasses(classes.size(), each, inputs()));
    }

    @Override
    Steps compute(State<Long> before, long kind, Value[] letter) {
        return latched.isPossible(before.memory(), letter)
                ? remembering(system.steps(before.inner(), letter), latched.held(letter))
                : new Steps.Collector().steps();
    }

    @Override
    public Optional<List<DataStep>> dataSteps(int configuration) {
        return system.dataSteps(get(configuration).inner());
    }

    @Override
    public boolean canBePacked() {
        return system instanceof NetworkSystem network && network.canBePacked();
    }

    @Override
    public PackedNetwork packed() {
        return network().packed(latched);
    }

    private NetworkSystem network() {
        return (NetworkSystem) system;
    }

    /** What is remembered is one register more. */
    @Override
    public GlobalState state(int configuration) {
        State<Long> state = get(configuration);
        GlobalState inner = network().state(state.inner());
        List<Sent> registers = new ArrayList<>(inner.registers());
        registers.add(Sent.of(new Value.IntegerValue(state.memory())));
        return new GlobalState(inner.parts(), registers, inner.problem());
    }

    @Override
    public int configuration(GlobalState state) {
        int last = state.registers().size() - 1;
        Sent.Messages memory = (Sent.Messages) state.registers().get(last);
        Value.IntegerValue held = (Value.IntegerValue) memory.values().get(0);
        List<Sent> registers = state.registers().subList(0, last);
        GlobalState inner = new GlobalState(state.parts(), registers, state.problem());
        return number(network().configuration(inner), held.value());
    }

    @Override
    public int cube(IntFunction<Sent> shown) {
        return network().cube(shown);
    }

    @Override
    String words(Long held) {
        return held == 0 ? "" : Long.toBinaryString(held);
    }
}
