package arcomat.analysis.evolution;

import arcomat.analysis.evolution.Edits.Edit;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.semantics.Promise;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What happened to the promises of a component along its versions.
 *
 * @param titles of the versions, the oldest first
 * @param verdicts per version those on each earlier one, the oldest first
 * @param breaks where a promise that had been kept stopped being kept
 */
public record Evolution(List<String> titles, List<List<Verdict>> verdicts, List<Break> breaks) {
    public Evolution {
        titles = List.copyOf(titles);
        verdicts = verdicts.stream().map(List::copyOf).toList();
        breaks = List.copyOf(breaks);
    }

    /**
     * A version that no longer keeps what the version before it kept.
     *
     * @param version its position
     * @param promise position of the version that had promised
     * @param culprits edits without any one of which the promise would still be kept
     */
    public record Break(int version, int promise, Verdict verdict, List<Culprit> culprits) {
        public Break {
            culprits = List.copyOf(culprits);
        }
    }

    /**
     * An edit.
     *
     * @param old a transition, beginning or automaton before; empty where it is new
     * @param fresh the same after; empty where it is gone
     */
    public record Culprit(Optional<Span> old, Optional<Span> fresh) {}

    /** Compares each version with all earlier ones. */
    public static Evolution of(List<Promise> versions, Budget budget) {
        List<List<Verdict>> verdicts = new ArrayList<>();
        List<Break> breaks = new ArrayList<>();
        for (int version = 0; version < versions.size(); version++) {
            List<Verdict> row = new ArrayList<>();
            for (int promise = 0; promise < version; promise++) {
                Verdict verdict =
                        Refinement.check(versions.get(version), versions.get(promise), budget);
                row.add(verdict);
                boolean kept =
                        promise == version - 1
                                || verdicts.get(version - 1).get(promise).answer() == Answer.HOLDS;
                if (kept && verdict.answer() == Answer.FAILS) {
                    breaks.add(
                            new Break(
                                    version,
                                    promise,
                                    verdict,
                                    culprits(versions, version, promise, budget)));
                }
            }
            verdicts.add(row);
        }
        return new Evolution(versions.stream().map(Promise::title).toList(), verdicts, breaks);
    }

    private static List<Culprit> culprits(
            List<Promise> versions, int version, int promise, Budget budget) {
        List<Culprit> culprits = new ArrayList<>();
        for (Edit edit : Edits.between(versions.get(version - 1), versions.get(version))) {
            boolean guilty =
                    edit.undone()
                            .map(u -> Refinement.check(u, versions.get(promise), budget))
                            .filter(verdict -> verdict.answer() == Answer.HOLDS)
                            .isPresent();
            if (guilty) {
                culprits.add(new Culprit(edit.old(), edit.fresh()));
            }
        }
        return culprits;
    }

    /** Fails if some version does not keep what the one before it promises. */
    public Answer answer() {
        Answer worst = Answer.HOLDS;
        for (int version = 1; version < verdicts.size(); version++) {
            worst = worst.and(verdicts.get(version).get(version - 1).answer());
        }
        return worst;
    }
}
