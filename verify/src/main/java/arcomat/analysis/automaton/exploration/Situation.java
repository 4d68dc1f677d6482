package arcomat.analysis.automaton.exploration;

import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.RunProperty.Difference;
import arcomat.analysis.search.letter.Letters;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Fault;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What may happen in a reachable configuration on one kind of letter.
 *
 * @param letter messages by position of the input port, null for silence
 * @param alternatives one per enabled transition, in text order
 * @param faults of the guards that go wrong
 * @param wrapping indices of the transitions of which an integer wraps around
 * @param silenced where nothing answers, indices of the transitions that lack nothing but messages
 *     that their guards negate
 */
public record Situation(
        Visit visit,
        Value[] letter,
        List<Alternative> alternatives,
        List<Fault> faults,
        List<Integer> wrapping,
        List<Integer> silenced) {

    private static final Comparator<Situation> SIMPLE_FIRST =
            Comparator.<Situation>comparingInt(each -> each.visit.length())
                    .thenComparingInt(Situation::messages);

    /**
     * An enabled transition.
     *
     * @param reaction empty where the right-hand side goes wrong
     * @param next number of the visit that it leads to; -1 where it goes wrong
     */
    public record Alternative(
            Trace.Taken taken, Optional<Reaction> reaction, Optional<Fault> fault, int next) {}

    public int state() {
        return visit.configuration().state();
    }

    /** Whether no transition answers, well or wrong. */
    public boolean isUnhandled() {
        return alternatives.isEmpty() && faults.isEmpty();
    }

    public boolean isSilent() {
        return Letters.messages(letter) == 0;
    }

    /** The better witness: the way to it is shorter, or has fewer messages; else the first. */
    public static Situation simpler(Situation first, Situation second) {
        return SIMPLE_FIRST.compare(second, first) < 0 ? second : first;
    }

    private int messages() {
        return visit.messages() + Letters.messages(letter);
    }

    /** All that is shown. */
    public Set<RunProperty> shows() {
        Set<RunProperty> shown = new HashSet<>();
        shown.add(new RunProperty.Reached(state()));
        faults.forEach(fault -> shown.add(wrong(fault)));
        wrapping.forEach(each -> shown.add(new RunProperty.Overflow(each)));
        silenced.forEach(each -> shown.add(new RunProperty.Silenced(each)));
        if (isUnhandled()) {
            shown.add(new RunProperty.Unhandled(state(), isSilent()));
        }
        for (int i = 0; i < alternatives.size(); i++) {
            shown.add(new RunProperty.Enabled(alternatives.get(i).taken().index()));
            alternatives.get(i).fault().ifPresent(fault -> shown.add(wrong(fault)));
            for (int j = i + 1; j < alternatives.size(); j++) {
                together(alternatives.get(i), alternatives.get(j), shown);
            }
        }
        return shown;
    }

    private static RunProperty wrong(Fault fault) {
        return new RunProperty.Wrong(fault.taken().orElseThrow().index(), fault.kind());
    }

    private static void together(Alternative one, Alternative two, Set<RunProperty> shown) {
        int first = one.taken().index();
        int second = two.taken().index();
        shown.add(new RunProperty.Together(first, second, Difference.ANY));
        if (one.reaction().isEmpty() || two.reaction().isEmpty()) {
            return;
        }
        Reaction here = one.reaction().get();
        Reaction there = two.reaction().get();
        if (!here.output().equals(there.output())) {
            shown.add(new RunProperty.Together(first, second, Difference.OUTPUT));
        }
        if (!here.next().equals(there.next())) {
            shown.add(new RunProperty.Together(first, second, Difference.TARGET));
        }
    }
}
