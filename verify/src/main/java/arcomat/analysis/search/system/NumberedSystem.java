package arcomat.analysis.search.system;

import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.step.StepCache;
import arcomat.analysis.search.step.Steps;
import arcomat.model.Trace;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * A system that numbers its configurations as it meets them, and computes their steps once.
 *
 * @param <C> a configuration, by equality
 */
abstract class NumberedSystem<C> implements TransitionSystem {
    private final Numbering<C> configurations = new Numbering<>();
    private final List<StepCache> steps = new ArrayList<>();

    /** The steps with one letter of a kind, the first that was met. */
    abstract Steps compute(C before, long kind, Value[] letter);

    final int number(C configuration) {
        int number = configurations.number(configuration);
        if (number == steps.size()) {
            steps.add(new StepCache());
        }
        return number;
    }

    final C get(int configuration) {
        return configurations.get(configuration);
    }

    @Override
    public final Steps steps(int configuration, long kind, Value[] letter) {
        StepCache known = steps.get(configuration);
        Steps found = known.find(kind);
        return found != null ? found : known.add(kind, compute(get(configuration), kind, letter));
    }

    @Override
    public Set<Trace.Cause> used() {
        Set<Trace.Cause> causes = new LinkedHashSet<>();
        steps.forEach(each -> each.collectUsed(causes));
        return causes;
    }

    @Override
    public final int size() {
        return configurations.size();
    }
}
