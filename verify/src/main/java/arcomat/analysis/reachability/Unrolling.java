package arcomat.analysis.reachability;

import arcomat.analysis.reachability.Reachability.Place;
import arcomat.analysis.reachability.Reachability.Run;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.automaton.StepRelation.Start;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * All runs of one automaton up to some length, from a beginning or from anywhere, as claims to a
 * solver. On the way nothing goes wrong.
 *
 * @param <T> formulas of the solver
 */
public final class Unrolling<T> {
    private final Subject subject;
    private final boolean begins;
    private final Logic<T> logic;
    private final List<SymbolicTransitions<T>> transitions = new ArrayList<>();
    private final List<StatePredicate<T>> impossible = new ArrayList<>();

    /**
     * What is so or not at an instant.
     *
     * @param <T> formulas of the solver
     */
    public interface StatePredicate<T> {
        T at(SymbolicTransitions<T> there);
    }

    /**
     * @param begins whether runs start with a beginning of the automaton; else anywhere
     */
    public Unrolling(Subject subject, boolean begins, Logic<T> logic) {
        this.subject = subject;
        this.begins = begins;
        this.logic = logic;
    }

    public boolean isExact() {
        return logic.isExact();
    }

    /** Makes the runs one letter longer; at first, they have none. */
    public void extend() {
        Instant<T> instant = logic.instant();
        SymbolicTransitions<T> next =
                new SymbolicTransitions<>(subject, logic, instant, earlier(instant));
        transitions.add(next);
        logic.claim(next.wellFormed());
        if (transitions.size() > 1) {
            step(transitions.get(transitions.size() - 2), next.instant());
        } else if (begins) {
            List<Start> starts = subject.relation().starts();
            logic.claim(
                    logic.or(starts.stream().map(start -> begins(start, next.instant())).toList()));
        }
        impossible.forEach(known -> claimNever(known, next));
    }

    /** Latched ports keep their message: which have had one before, the letter before tells. */
    private Function<Port, T> earlier(Instant<T> instant) {
        if (!transitions.isEmpty()) {
            return transitions.get(transitions.size() - 1).instant()::has;
        }
        if (begins) {
            return port -> logic.of(subject.isAlwaysThere(port));
        }
        return subject.latchable().isEmpty() ? instant::has : beforehand(instant)::has;
    }

    /** What was read before a run that begins anywhere; of that, latched messages matter only. */
    private Instant<T> beforehand(Instant<T> first) {
        SymbolicTransitions<T> before = new SymbolicTransitions<>(subject, logic, logic.instant());
        logic.claim(before.instant().isWellTyped());
        logic.claim(before.keepsLatched(first));
        return before.instant();
    }

    private void step(SymbolicTransitions<T> before, Instant<T> next) {
        logic.claim(before.keepsLatched(next));
        List<T> steps = new ArrayList<>();
        for (int i = 0; i < subject.automaton().transitions().size(); i++) {
            steps.add(before.step(i, next));
        }
        logic.claim(logic.or(steps));
    }

    private T begins(Start start, Instant<T> first) {
        List<T> all = new ArrayList<>();
        all.add(first.isIn(start.configuration().state()));
        List<Variable> variables = subject.automaton().variables();
        for (int i = 0; i < variables.size(); i++) {
            all.add(first.is(variables.get(i), start.configuration().variables().get(i)));
        }
        return logic.and(all);
    }

    /** It is known that no configuration shows it. */
    public void exclude(StatePredicate<T> shown) {
        impossible.add(shown);
        transitions.forEach(instant -> claimNever(shown, instant));
    }

    private void claimNever(StatePredicate<T> shown, SymbolicTransitions<T> there) {
        logic.claim(logic.not(shown.at(there)));
    }

    /** Whether a run leads from what is so to what is so; if so, looks at an example. */
    public Logic.Answer leads(StatePredicate<T> from, StatePredicate<T> to, Consumer<Run> example) {
        return logic.assuming(
                List.of(from.at(transitions.get(0)), atEnd(to)), () -> example.accept(run()));
    }

    /** Whether the end of a run shows it; if so, looks at an example. */
    public Logic.Answer endsWith(StatePredicate<T> shown, Consumer<Run> example) {
        return logic.assuming(List.of(atEnd(shown)), () -> example.accept(run()));
    }

    /** Whether the end of a run shows it. */
    Logic.Answer endsWith(StatePredicate<T> shown) {
        return logic.assuming(List.of(atEnd(shown)));
    }

    private T atEnd(StatePredicate<T> shown) {
        return shown.at(transitions.get(transitions.size() - 1));
    }

    /** Whether the end of a run may be the first to show it. */
    public Logic.Answer endsFirstWith(StatePredicate<T> shown) {
        List<T> assumed = new ArrayList<>();
        for (SymbolicTransitions<T> before : transitions.subList(0, transitions.size() - 1)) {
            assumed.add(logic.not(shown.at(before)));
        }
        assumed.add(atEnd(shown));
        return logic.assuming(assumed);
    }

    /** After the answer yes: the example's run, with the letter at its end. */
    private Run run() {
        List<Instant<T>> instants = transitions.stream().map(SymbolicTransitions::instant).toList();
        List<Place> places = instants.stream().map(Instant::place).toList();
        List<Value[]> letters = instants.stream().map(Instant::letter).toList();
        int last = letters.size() - 1;
        return new Run(letters.subList(0, last), places, letters.get(last));
    }
}
