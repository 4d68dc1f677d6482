package arcomat.laws;

import arcomat.analysis.automaton.Analyses;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.search.Budget;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.ExpressionText;
import arcomat.model.Component;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Whatever the grammar allows and the checks let pass, every command has an answer to: a component
 * refines itself, is analyzed, and runs alike in both engines.
 */
final class ExpressionsAreTaken implements Law {
    /** Compiling takes longer than all the rest: of so many models one is compiled. */
    private static final int COMPILED = 8;

    /** Who gives up has an answer, too: more expressions are worth more than more of these. */
    private static final long STATES = 50;

    private static final long PATIENCE = 100;

    @Override
    public String name() {
        return "13 expressions are taken";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return ExpressionText.models(draw);
    }

    @Override
    public Outcome check(Models models) {
        Component component = models.component(Pairs.LEFT);
        Promise promise = Questions.promise(component);
        if (Questions.fails(Refinement.check(promise, promise, budget()))) {
            return Outcome.broken(
                    "does not refine itself", Questions.command(Pairs.LEFT, Pairs.LEFT));
        }
        Analyses.examine(promise, List.of(), budget());
        if (models.seed() % COMPILED == 0) {
            return new EnginesAgree().check(models);
        }
        RunsAreAllowed.run(component, models.seed(), COMPILED);
        return Outcome.KEPT;
    }

    private static Budget budget() {
        AtomicInteger asked = new AtomicInteger();
        return new Budget(() -> asked.incrementAndGet() > PATIENCE, STATES).patient(PATIENCE);
    }
}
