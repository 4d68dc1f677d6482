package arcomat.analysis.refinement;

import arcomat.analysis.coupling.Coupling;
import arcomat.analysis.coupling.CouplingCheck;
import arcomat.analysis.coupling.CouplingSearch;
import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.analysis.search.product.Certificate.Form;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.semantics.Promise;
import arcomat.semantics.value.GivenUp;
import arcomat.semantics.value.SmallType;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * Refinement of one automaton by another, shown by conditions over their variables. It is only ever
 * shown: where no conditions are found, nothing is known.
 */
final class CoupledRefinement {
    /** So many pairs are looked at before: a counterexample that is near is found by the search. */
    static final int FEW_PAIRS = 200;

    private static final String PROVED =
            "proved by conditions over variables, verified; not all values were tried";

    private static final String NOTHING_FOUND = "no conditions over variables were found: ";

    private static final String NOT_EXCLUDED = "those that were tried do not exclude that ";

    private CoupledRefinement() {}

    /** Whether variables have so many values that a search of all may not end. */
    static boolean isWorthwhile(Promise left, Promise right) {
        return areFlat(left, right)
                && Stream.of(left, right)
                        .flatMap(each -> each.automata().stream())
                        .flatMap(each -> each.variables().stream())
                        .anyMatch(CoupledRefinement::isWide);
    }

    /** Whether messages have so many values that a search has to ask somebody what they are. */
    static boolean readsMuch(Promise left, Promise right) {
        return areFlat(left, right)
                && left.component().inputs().stream().anyMatch(port -> isLarge(port.type()));
    }

    private static boolean isWide(Variable variable) {
        return isLarge(variable.type());
    }

    private static boolean isLarge(Type type) {
        return SmallType.values(type).isEmpty();
    }

    private static boolean areFlat(Promise left, Promise right) {
        return Stream.of(left, right)
                .allMatch(each -> each.automata().size() == 1 && !each.devices());
    }

    /**
     * What became of a search for conditions.
     *
     * @param proof that has been checked, told as briefly as possible; empty where none was found
     * @param obstacle that stood in the way; empty where it is not known
     */
    record Attempt(Optional<Supplier<Certificate>> proof, Optional<String> obstacle) {
        static Attempt without(Optional<String> obstacle) {
            return new Attempt(Optional.empty(), obstacle);
        }

        /** Where something stood in the way, that is noted, unless it has been said. */
        Verdict noted(Verdict verdict) {
            return obstacle.filter(each -> verdict.answer() == Verdict.Answer.UNKNOWN)
                    .filter(each -> !verdict.reason().equals(each))
                    .map(each -> verdict.with(NOTHING_FOUND + each))
                    .orElse(verdict);
        }
    }

    static Attempt attempt(Promise left, Promise right, Budget budget) {
        return areFlat(left, right)
                ? Budget.within(
                        () -> searched(left, right, budget),
                        reason -> Attempt.without(Optional.of(reason)))
                : Attempt.without(Optional.empty());
    }

    private static Attempt searched(Promise left, Promise right, Budget budget) {
        Coupling coupling = coupling(left, right);
        CouplingSearch search = CouplingSearch.of(coupling, budget::isSpent);
        Optional<String> problem = problem(coupling, search.proposal(), budget);
        return problem.isEmpty()
                ? new Attempt(Optional.of(() -> told(coupling, search, budget)), Optional.empty())
                : Attempt.without(search.blamed().or(() -> problem.map(NOT_EXCLUDED::concat)));
    }

    private static Optional<String> problem(Coupling coupling, List<Entry> entries, Budget budget) {
        return CouplingCheck.problem(coupling, entries, budget::isSpent);
    }

    private static Certificate told(Coupling coupling, CouplingSearch search, Budget budget) {
        List<Entry> all = search.proposal();
        Optional<List<Entry>> fewer =
                Budget.within(
                        () ->
                                Optional.of(search.shortened())
                                        .filter(each -> problem(coupling, each, budget).isEmpty()),
                        reason -> Optional.empty());
        return new Certificate(Form.CONDITIONS, fewer.orElse(all));
    }

    /**
     * What is wrong with such a proof; empty where it is one.
     *
     * @throws GivenUp where that could not be decided
     */
    static Optional<String> problem(
            Promise left, Promise right, Certificate certificate, Budget budget) {
        if (!areFlat(left, right)) {
            return Optional.of("conditions over variables are about two automata, no compositions");
        }
        return problem(coupling(left, right), certificate.entries(), budget);
    }

    private static Coupling coupling(Promise left, Promise right) {
        return Coupling.of(subject(left), subject(right));
    }

    private static Coupling.Subject subject(Promise promise) {
        return new Coupling.Subject(
                promise.component(), promise.automata().get(0), promise.arguments());
    }

    static Verdict verdict() {
        return Verdict.holds(Optional.of(true), List.of(PROVED), Explored.NOTHING);
    }
}
