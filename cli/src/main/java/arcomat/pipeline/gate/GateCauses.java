package arcomat.pipeline.gate;

import arcomat.analysis.evolution.ChangeImpact;
import arcomat.analysis.evolution.Gate;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.model.Component;
import arcomat.model.Model;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * A composition whose own text did not change owes what became of it to its parts. It needs no
 * reason of its own if they have one: parts that refine cannot break a whole (the theorem of
 * compositional refinement), so what breaks it are parts that have to say why themselves.
 */
final class GateCauses {
    private final Map<String, Gate.Entry> entries = new LinkedHashMap<>();

    private GateCauses(List<Gate.Entry> entries) {
        entries.forEach(entry -> this.entries.put(entry.name(), entry));
    }

    static List<Gate.Entry> of(List<Gate.Entry> entries, Model model, ChangeImpact changed) {
        GateCauses causes = new GateCauses(entries);
        List<Component> wholes =
                model.components().stream()
                        .filter(each -> each.isComposite() && !changed.itself(each))
                        .filter(each -> causes.asksForOne(each.qualifiedName()))
                        .toList();
        boolean more = true;
        while (more) {
            more = false;
            for (Component whole : wholes) {
                more |= causes.find(whole);
            }
        }
        return List.copyOf(causes.entries.values());
    }

    private boolean asksForOne(String name) {
        Gate.Entry entry = entries.get(name);
        return entry != null && entry.change().relation().isDoubtful() && entry.excuse().isEmpty();
    }

    /** Whether something new was found; the parts of a part may have been looked at later. */
    private boolean find(Component whole) {
        Optional<Gate.Entry> worst = worst((Component.Composite) whole.body());
        if (worst.isEmpty()) {
            return false;
        }
        Gate.Entry entry = Objects.requireNonNull(entries.get(whole.qualifiedName()));
        Gate.Entry explained = entry.owedTo(worst.get());
        entries.put(entry.name(), explained);
        return !explained.equals(entry);
    }

    private Optional<Gate.Entry> worst(Component.Composite body) {
        Optional<Gate.Entry> worst = Optional.empty();
        for (Component.Part part : body.parts()) {
            Gate.Entry entry = entries.get(part.component().qualifiedName());
            if (entry != null
                    && entry.change().relation().isDoubtful()
                    && (worst.isEmpty() || isWorse(entry.answer(), worst.get().answer()))) {
                worst = Optional.of(entry);
            }
        }
        return worst;
    }

    private static boolean isWorse(Answer one, Answer other) {
        return one != other && one.and(other) == one;
    }
}
