package arcomat.pipeline.analysis;

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
    private final List<Proof> proofs = new ArrayList<>();

    @Override
    public Verdict refines(Promise left, Promise right, Budget budget) {
        Certification found = Certification.of(left, right, budget);
        return found.verdict().answer() == Answer.UNKNOWN
                ? unwritten(ENGINE.refines(left, right, budget))
                : remembered(PromiseProver.title(left, right), found);
    }

    /** Part by part, what is too much for a certificate may be shown. */
    private static Verdict unwritten(Verdict verdict) {
        return verdict.answer() == Answer.HOLDS ? verdict.with(Certification.NONE) : verdict;
    }

    @Override
    public Verdict keeps(Promise side, Invariant invariant, Budget budget) {
        Certification found = InvariantCertification.of(side, invariant, budget);
        return remembered(PromiseProver.title(side, invariant), found);
    }

    private Verdict remembered(String title, Certification found) {
        if (!found.certificates().isEmpty()) {
            proofs.add(new Proof(title, found.certificates()));
        }
        return found.verdict();
    }

    /** In the order of the questions. */
    List<Proof> proofs() {
        return List.copyOf(proofs);
    }
}
