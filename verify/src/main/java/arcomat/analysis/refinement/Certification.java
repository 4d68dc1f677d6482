package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Form;
import arcomat.semantics.Promise;
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

    /** So much work the second engine does alone, in assignments: some seconds. */
    private static final long WORK = 4_000_000;

    /** What is said where nothing can be written down. */
    public static final String NONE = "no certificate was found within the limits";

    /** So many pairs are searched unpacked, so that they can be written down at once. */
    private static final long FEW_PAIRS = 20_000;

    /** As {@link Refinement#check}, but without the short cut part by part. */
    public static Certification of(Promise left, Promise right, Budget budget) {
        Optional<Verdict> known = Refinement.comparable(left, right);
        if (known.isPresent()) {
            return new Certification(known.get(), List.of());
        }
        List<Certification> each =
                right.each().stream().map(one -> ofOne(left, one, budget)).toList();
        Verdict verdict = Refinement.all(each.stream().map(Certification::verdict).toList());
        if (verdict.answer() != Answer.HOLDS) {
            return new Certification(verdict, List.of());
        }
        List<Certificate> found = each.stream().flatMap(c -> c.certificates.stream()).toList();
        return found.size() == each.size()
                ? new Certification(verdict, found)
                : new Certification(verdict.with(NONE), List.of());
    }

    /**
     * Pairs that are to be written down are not packed. Where these are many, the answer is that of
     * the packed search, or of the second engine.
     */
    private static Certification ofOne(Promise left, Promise right, Budget budget) {
        Budget unpacked = budget.with(rule -> rule != Shortcut.PACKED && budget.takes(rule));
        if (!left.isComposition()) {
            return searched(left, right, unpacked);
        }
        Certification few = searched(left, right, unpacked.atMost(FEW_PAIRS));
        if (few.verdict.answer() != Answer.UNKNOWN) {
            return few;
        }
        Certification quick = searched(left, right, budget);
        return quick.verdict.answer() == Answer.HOLDS && quick.certificates.isEmpty()
                ? new Certification(quick.verdict, alone(left, right, unpacked))
                : quick;
    }

    /** With what the search leaves to be written down. */
    private static Certification searched(Promise left, Promise right, Budget budget) {
        List<Certificate> found = new ArrayList<>();
        Verdict verdict =
                Refinement.compare(
                        left,
                        right,
                        budget,
                        proof -> told(left, right, proof, budget).ifPresent(found::add));
        return new Certification(verdict, found);
    }

    /** Clauses that the second engine finds by itself, else pairs however many. */
    private static List<Certificate> alone(Promise left, Promise right, Budget unpacked) {
        return clausesAlone(() -> ComparedSystems.of(left, right, unpacked), unpacked)
                .map(List::of)
                .orElseGet(() -> searched(left, right, unpacked).certificates);
    }

    /** Clauses that the second engine finds by itself. */
    static Optional<Certificate> clausesAlone(Supplier<ComparedSystems> systems, Budget budget) {
        return onPaper(systems, () -> systems.get().clauses(WORK, budget), budget);
    }

    /** Such clauses as they would be written: what words do not tell without doubt is no proof. */
    static Optional<Certificate> onPaper(
            Supplier<ComparedSystems> systems,
            Supplier<Optional<Certificate>> clauses,
            Budget budget) {
        return Budget.within(
                () -> clauses.get().filter(each -> systems.get().problem(each, budget).isEmpty()),
                reason -> Optional.empty());
    }

    /**
     * Where a solver had to tell messages apart, conditions are preferred: to check them, another
     * one is asked.
     */
    private static Optional<Certificate> told(
            Promise left, Promise right, Supplier<Optional<Certificate>> proof, Budget budget) {
        Optional<Certificate> found = proof.get();
        boolean others =
                found.isPresent()
                        && found.get().form() == Form.PAIRS
                        && CoupledRefinement.readsMuch(left, right)
                        && budget.takes(Shortcut.CONDITIONS);
        if (others) {
            return CoupledRefinement.attempt(left, right, budget)
                    .proof()
                    .map(Supplier::get)
                    .or(() -> found);
        }
        return found.isPresent() && found.get().form() == Form.CLAUSES
                ? onPaper(() -> ComparedSystems.of(left, right, budget), () -> found, budget)
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
        return ComparedSystems.of(left, right, budget).problem(certificate, budget);
    }
}
