package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Automaton;
import arcomat.model.Trace;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Whether a refinement that holds says anything: which of the promises were ever called in. */
public final class Vacuity {
    private Vacuity() {}

    public static Verdict nothingAsked() {
        return Verdict.holds(
                Optional.of(true),
                List.of("nothing is promised: there is no automaton"),
                Explored.NOTHING);
    }

    /**
     * @param complete whether all was explored; else nothing is called empty
     */
    static List<String> notes(
            Promise right,
            TransitionSystem theirs,
            TraceInclusion.Result result,
            boolean complete) {
        List<String> notes = new ArrayList<>();
        int all = 0;
        for (Automaton automaton : right.automata()) {
            all += automaton.transitions().size();
        }
        Set<Trace.Cause> used = new HashSet<>();
        for (Trace.Cause cause : theirs.used()) {
            if (cause instanceof Trace.Taken) {
                used.add(cause);
            }
        }
        if (all > 0 && (complete || !used.isEmpty())) {
            notes.add(
                    used.isEmpty()
                            ? "empty: none of the %d transitions of %s took part"
                                    .formatted(all, right.title())
                            : (complete ? "" : "at least ")
                                    + "%d of %d transitions of %s took part"
                                            .formatted(used.size(), all, right.title()));
        }
        if (complete && result.chaosReached() && !result.promising()) {
            notes.add("empty: %s promises nothing after any input".formatted(right.title()));
        } else if (result.chaosReached()) {
            notes.add("some runs are allowed only because %s is in chaos".formatted(right.title()));
        }
        return notes;
    }
}
