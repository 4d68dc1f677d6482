package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Form;
import arcomat.analysis.search.product.CertificateCheck;
import arcomat.semantics.value.GivenUp;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * A verdict with its reasons: where a refinement holds, a certificate for each automaton of the
 * right side, by its title. It can be verified later, by whoever doubts the search.
 */
public record Certification(Verdict verdict, List<Certificate> certificates) {

    /**
     * As {@link Refinement#check}, but without the short cut part by part; and pairs that are to be
     * written down are not packed.
     */
    public static Certification of(Promise left, Promise right, Budget budget) {
        List<Certificate> found = new ArrayList<>();
        Optional<Verdict> known = Refinement.comparable(left, right);
        if (known.isPresent()) {
            return new Certification(known.get(), List.of());
        }
        List<Verdict> verdicts = new ArrayList<>();
        Budget unpacked = budget.with(rule -> rule != Shortcut.PACKED && budget.takes(rule));
        for (Promise each : right.each()) {
            verdicts.add(
                    Refinement.compare(
                            left,
                            each,
                            unpacked,
                            proof -> found.add(told(left, each, proof, budget))));
        }
        Verdict verdict = Refinement.all(verdicts);
        return new Certification(verdict, verdict.answer() == Answer.HOLDS ? found : List.of());
    }

    /**
     * Where a solver had to tell messages apart, conditions are preferred: to check them, another
     * one is asked.
     */
    private static Certificate told(
            Promise left, Promise right, Supplier<Certificate> proof, Budget budget) {
        Certificate found = proof.get();
        boolean others =
                found.form() == Form.PAIRS
                        && CoupledRefinement.readsMuch(left, right)
                        && budget.takes(Shortcut.CONDITIONS);
        return others
                ? CoupledRefinement.proof(left, right, budget).map(Supplier::get).orElse(found)
                : found;
    }

    /**
     * What is wrong with certificates for a refinement; empty where they prove it.
     *
     * @throws GivenUp where the refinement could not be decided either
     */
    public static Optional<String> problem(
            Promise left, Promise right, List<Certificate> certificates, Budget budget) {
        Optional<Verdict> known = Refinement.comparable(left, right);
        if (known.isPresent()) {
            List<Sentence> why = known.get().explanation();
            return Optional.of(why.isEmpty() ? known.get().reason() : why.get(0).text());
        }
        List<Promise> promises = right.each();
        if (certificates.size() != promises.size()) {
            return Optional.of(
                    "it is about %d automata, and there are %d"
                            .formatted(certificates.size(), promises.size()));
        }
        for (int i = 0; i < promises.size(); i++) {
            Promise each = promises.get(i);
            Optional<String> problem = problem(left, each, certificates.get(i), budget);
            if (problem.isPresent()) {
                return problem;
            }
        }
        return Optional.empty();
    }

    private static Optional<String> problem(
            Promise left, Promise right, Certificate certificate, Budget budget) {
        if (certificate.form() == Form.CONDITIONS) {
            return CoupledRefinement.problem(left, right, certificate, budget);
        }
        ComparedSystems systems = ComparedSystems.of(left, right, budget);
        return new CertificateCheck(
                        systems.left(),
                        systems.right(),
                        systems.observed(),
                        systems.outputs(),
                        certificate,
                        budget)
                .problem();
    }
}
