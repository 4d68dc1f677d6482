package arcomat.analysis.automaton;

import arcomat.analysis.automaton.Situation.Alternative;
import arcomat.analysis.smt.RunProperty;
import arcomat.analysis.smt.RunProperty.Difference;
import arcomat.semantics.automaton.Reaction;
import arcomat.semantics.expression.Fault;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Notes which questions are answered by what has been seen. */
final class Seen implements Watcher {
    private final Set<RunProperty> questions = new HashSet<>();

    Set<RunProperty> questions() {
        return questions;
    }

    @Override
    public void see(Situation situation) {
        questions.addAll(shownBy(situation));
    }

    /** All that a situation shows. */
    static Set<RunProperty> shownBy(Situation situation) {
        Set<RunProperty> shown = new HashSet<>();
        shown.add(new RunProperty.Reached(situation.state()));
        situation.faults().forEach(fault -> shown.add(wrong(fault)));
        situation.wrapping().forEach(each -> shown.add(new RunProperty.Overflow(each)));
        if (situation.isUnhandled()) {
            shown.add(new RunProperty.Unhandled(situation.state(), situation.isSilent()));
        }
        List<Alternative> all = situation.alternatives();
        for (int i = 0; i < all.size(); i++) {
            shown.add(new RunProperty.Enabled(all.get(i).taken().index()));
            all.get(i).fault().ifPresent(fault -> shown.add(wrong(fault)));
            for (int j = i + 1; j < all.size(); j++) {
                together(all.get(i), all.get(j), shown);
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
