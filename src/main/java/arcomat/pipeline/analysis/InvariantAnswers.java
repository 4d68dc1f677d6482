package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.model.Model;
import arcomat.model.Value;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.step.Progress;
import arcomat.semantics.expression.Arguments;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InvariantSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Proves the invariants of components, or says of each why not. */
final class InvariantAnswers {
    private final Model model;
    private final CheckedModels checked;
    private final List<Component> components;
    private final Budget budget;
    private final Progress progress;
    private final List<Answered> answers = new ArrayList<>();

    /**
     * @param checked the models that were lowered to the model
     */
    InvariantAnswers(
            Model model,
            CheckedModels checked,
            List<Component> components,
            Budget budget,
            Progress progress) {
        this.model = model;
        this.checked = checked;
        this.components = components;
        this.budget = budget;
        this.progress = progress;
    }

    List<Answered> all() {
        InstanceArguments instances = InstanceArguments.in(model);
        for (Component component : components) {
            if (!component.invariants().isEmpty()) {
                prove(component, arguments(component, instances));
            }
        }
        for (ComponentSymbol symbol : checked.workspace().components()) {
            if (checked.loaded().isNamedByUser(symbol.nameSpan().file().path())) {
                symbol.ownInvariants().forEach(each -> addObstacle(symbol, each));
            }
        }
        return answers;
    }

    /** Its defaults, else those of each of its instances. */
    private static Set<List<Value>> arguments(Component component, InstanceArguments instances) {
        return component.hasDefaults()
                ? Set.of(Arguments.complete(component, List.of()))
                : instances.of(component);
    }

    private void prove(Component component, Set<List<Value>> arguments) {
        for (Invariant invariant : component.invariants()) {
            for (List<Value> each : arguments) {
                String title = Promise.of(component, each).title();
                progress.step("proving invariant " + invariant.name() + " of " + title);
                Verdict verdict = InvariantProof.check(component, each, invariant, budget);
                add(title, invariant, verdict);
            }
            if (arguments.isEmpty()) {
                add(component.qualifiedName(), invariant, Verdict.unknown(missing(component)));
            }
        }
    }

    private void add(String title, Invariant invariant, Verdict verdict) {
        answers.add(Answered.ofInvariant(title, invariant.name(), invariant.span(), verdict));
    }

    private static String missing(Component component) {
        return "it takes %s, which no part fixes"
                .formatted(MainComponent.signature(component.parameters()));
    }

    /** What {@code check} has told, and nobody has said to be meant. */
    private void addObstacle(ComponentSymbol component, InvariantSymbol invariant) {
        boolean isMeant =
                checked.suppressed().stream()
                        .anyMatch(each -> each.finding().span().equals(invariant.nameSpan()));
        if (isMeant) {
            return;
        }
        invariant
                .obstacle()
                .or(() -> InstancePromises.genericWithoutPart(component, model))
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
