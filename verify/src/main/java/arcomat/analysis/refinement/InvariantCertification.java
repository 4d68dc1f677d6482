package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Form;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.model.Invariant;
import arcomat.semantics.Promise;
import arcomat.semantics.value.GivenUp;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Why invariants hold, to be written down, and to be verified later by whoever doubts the search.
 * Clauses are preferred, which can be read; else there are the pairs of a search, of the component
 * beside its observer with one that never speaks.
 */
public final class InvariantCertification {
    private InvariantCertification() {}

    /**
     * As {@link InvariantProof#check}; where it holds, with a certificate, if one was found.
     *
     * @param asked the component with its arguments
     */
    public static Certification of(Promise asked, Invariant invariant, Budget budget) {
        InvariantProof proof = InvariantProof.of(asked, invariant, budget);
        List<Certificate> found = new ArrayList<>();
        Verdict verdict =
                proof.verdict(
                        shown -> {
                            if (shown.invariant().isPresent()) {
                                shown.certificate().ifPresent(found::add);
                            }
                        });
        if (verdict.answer() != Answer.HOLDS) {
            return new Certification(verdict, List.of());
        }
        return Certification.onPaper(proof::apart, () -> found.stream().findFirst(), budget)
                .or(() -> Certification.clausesAlone(proof::apart, budget))
                .or(() -> pairs(proof, budget))
                .map(certificate -> new Certification(verdict, List.of(certificate)))
                .orElseGet(() -> new Certification(verdict.with(Certification.NONE), List.of()));
    }

    private static Optional<Certificate> pairs(InvariantProof proof, Budget budget) {
        Budget unpacked = budget.with(rule -> rule != Shortcut.PACKED && budget.takes(rule));
        return Budget.within(
                () -> {
                    ComparedSystems systems = proof.together(unpacked);
                    TraceInclusion inclusion = systems.inclusion(unpacked);
                    TraceInclusion.Result result = inclusion.run();
                    boolean ended = result.failure().isEmpty() && result.stopped().isEmpty();
                    return ended ? inclusion.certificate() : Optional.empty();
                },
                reason -> Optional.empty());
    }

    /**
     * What is wrong with certificates for an invariant; empty where they prove it.
     *
     * @throws GivenUp where that could not be decided
     */
    public static Optional<String> problem(
            Promise asked, Invariant invariant, List<Certificate> certificates, Budget budget) {
        InvariantProof proof = InvariantProof.of(asked, invariant, budget);
        Optional<Verdict> known = proof.withoutSearch();
        if (known.isPresent()) {
            List<Sentence> why = known.get().explanation();
            return Optional.of(why.isEmpty() ? known.get().reason() : why.get(0).text());
        }
        if (certificates.size() != 1) {
            return Optional.of(
                    "there are %d certificates for one invariant".formatted(certificates.size()));
        }
        Certificate certificate = certificates.get(0);
        return certificate.form() == Form.PAIRS
                ? proof.together(budget).problem(certificate, budget)
                : proof.apart().problem(certificate, budget);
    }
}
