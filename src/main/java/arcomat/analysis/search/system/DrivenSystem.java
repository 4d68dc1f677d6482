package arcomat.analysis.search.system;

import arcomat.analysis.search.letter.LatchedPorts;
import arcomat.analysis.search.letter.LetterClasses;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.smt.DataStep;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A system as its environment really drives it: a latched port that has got a message holds one
 * from then on. Letters in which it is empty again cannot happen, and have no steps. Only for the
 * left side of a comparison; the right one then meets no other letters.
 *
 * <p>Remembers a bit for each latched port that holds something.
 */
public final class DrivenSystem extends HistorySystem<Long> {
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
    String words(Long held) {
        return held == 0 ? "" : Long.toBinaryString(held);
    }
}
