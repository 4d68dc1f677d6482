package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.NoRun;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.model.Value;
import arcomat.pipeline.Progress;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.semantics.Promise;
import arcomat.semantics.value.TooManyWays;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InvariantSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Proves the invariants of components, or says of each why not. */
final class InvariantAnswers {
    private final LoweredModels models;
    private final PromiseProver prover;
    private final NoRun noRun;
    private final Budget budget;
    private final Progress progress;
    private final List<Answered> answers = new ArrayList<>();

    InvariantAnswers(
            LoweredModels models,
            PromiseProver prover,
            NoRun noRun,
            Budget budget,
            Progress progress) {
        this.models = models;
        this.noRun = noRun;
        this.prover = prover;
        this.budget = budget;
        this.progress = progress;
    }

    /**
     * Of all invariants of the components that are asked about.
     *
     * @param instances the arguments that parts give
     */
    List<Answered> all(InstanceArguments instances) {
        for (Component component : models.named()) {
            if (!component.invariants().isEmpty()) {
                prove(component, instances.orDefaultsOf(component));
            }
        }
        for (ComponentSymbol symbol : models.checked().workspace().components()) {
            if (models.isNamed(symbol.nameSpan())) {
                symbol.ownInvariants().forEach(each -> addObstacle(symbol, each));
            }
        }
        return answers;
    }

    private void prove(Component component, Set<List<Value>> arguments) {
        for (Invariant invariant : component.invariants()) {
            if (component.isOnlyRun()) {
                answers.add(unknown(component, invariant, "it has " + TooManyWays.REASON));
                continue;
            }
            for (List<Value> each : arguments) {
                Promise side = Promise.of(component, each);
                progress.step("proving invariant " + invariant.name() + " of " + side.title());
                Verdict verdict = noRun.noted(side, prover.keeps(side, invariant, budget));
                String name = invariant.name();
                answers.add(Answered.ofInvariant(side, name, invariant.span(), verdict));
            }
            if (arguments.isEmpty()) {
                answers.add(unknown(component, invariant, missing(component)));
            }
        }
    }

    private static Answered unknown(Component component, Invariant invariant, String reason) {
        return Answered.ofInvariant(
                component.qualifiedName(),
                invariant.name(),
                invariant.span(),
                Verdict.unknown(reason));
    }

    private static String missing(Component component) {
        return "it takes %s, which no part fixes"
                .formatted(MainComponent.signature(component.parameters()));
    }

    /** What {@code check} has told, and nobody has said to be meant. */
    private void addObstacle(ComponentSymbol component, InvariantSymbol invariant) {
        boolean isMeant =
                models.checked().suppressed().stream()
                        .anyMatch(each -> each.finding().span().equals(invariant.nameSpan()));
        if (isMeant) {
            return;
        }
        invariant
                .obstacle()
                .or(() -> InstancePromises.genericWithoutPart(component, models.model()))
                .ifPresent(
                        reason ->
                                answers.add(
                                        Answered.ofInvariant(
                                                component.qualifiedName(),
                                                invariant.name(),
                                                invariant.nameSpan(),
                                                Verdict.unknown(reason))));
    }
}
