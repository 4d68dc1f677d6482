package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.model.Invariant;
import arcomat.pipeline.explored.ExploredFolder;
import arcomat.pipeline.explored.ExploredSearches;
import arcomat.semantics.Promise;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.function.Function;

/** The engine of this tool, which keeps what it explores in files, a folder for each promise. */
record ProverOnDisk(ExploredFolder explored) implements PromiseProver {
    @Override
    public Verdict refines(Promise left, Promise right, Budget budget) {
        return kept(
                PromiseProver.title(left, right),
                searches -> refines(left, right, budget, searches));
    }

    /** As above, in a place for this very question. */
    static Verdict refines(Promise left, Promise right, Budget budget, ExploredSearches searches) {
        return searches.told(
                Refinement.check(
                        left, right, budget, one -> Optional.of(searches.stores(one, budget))));
    }

    @Override
    public Verdict keeps(Promise side, Invariant invariant, Budget budget) {
        return kept(
                PromiseProver.title(side, invariant),
                searches ->
                        searches.told(
                                InvariantProof.check(
                                        side.component(),
                                        side.arguments(),
                                        invariant,
                                        budget,
                                        Optional.of(searches.stores(side, budget)))));
    }

    private Verdict kept(String title, Function<ExploredSearches, Verdict> question) {
        try (ExploredSearches searches = explored.of(title)) {
            return question.apply(searches);
        } catch (IOException unclosed) {
            throw new UncheckedIOException(unclosed);
        }
    }
}
