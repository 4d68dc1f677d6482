package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.NoRun;
import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.InvariantCertification;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Invariant;
import arcomat.report.verdict.CertificateText.Proof;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;

/** The engine of this tool, which remembers why all holds that does. */
final class CertifyingProver implements PromiseProver {
    private final NoRun noRun;
    private final List<Proof> proofs = new ArrayList<>();

    /**
     * @param noRun says where a side has no run
     */
    CertifyingProver(NoRun noRun) {
        this.noRun = noRun;
    }

    @Override
    public Verdict refines(Promise left, Promise right, Budget budget) {
        Certification found = Certification.of(left, right, budget);
        return found.verdict().answer() == Answer.UNKNOWN
                ? unwritten(ENGINE.refines(left, right, budget))
                : remembered(left, PromiseProver.title(left, right), found);
    }

    /** Part by part, what is too much for a certificate may be shown. */
    private static Verdict unwritten(Verdict verdict) {
        return verdict.answer() == Answer.HOLDS ? verdict.with(Certification.NONE) : verdict;
    }

    @Override
    public Verdict keeps(Promise side, Invariant invariant, Budget budget) {
        Certification found = InvariantCertification.of(side, invariant, budget);
        return remembered(side, PromiseProver.title(side, invariant), found);
    }

    private Verdict remembered(Promise side, String title, Certification found) {
        Verdict noted = noRun.noted(side, found.verdict());
        if (!found.certificates().isEmpty()) {
            proofs.add(new Proof(title, NoRun.notes(noted), found.certificates()));
        }
        return noted;
    }

    /** In the order of the questions. */
    List<Proof> proofs() {
        return List.copyOf(proofs);
    }
}
