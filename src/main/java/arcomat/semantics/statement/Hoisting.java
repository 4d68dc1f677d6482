package arcomat.semantics.statement;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Declares some local variables before all steps, not in them. */
final class Hoisting {
    private Hoisting() {}

    /**
     * Steps that set them where others declare them.
     *
     * @param names of those variables
     */
    static List<Step> of(List<Step> steps, Set<String> names) {
        List<Step> all = new ArrayList<>();
        for (Step each : steps) {
            if (each instanceof Step.Declare local && names.contains(local.cell().name())) {
                all.add(new Step.Set(local.cell(), local.value()));
            } else if (each instanceof Step.Choose choose) {
                all.add(
                        new Step.Choose(
                                choose.condition(),
                                of(choose.then(), names),
                                of(choose.otherwise(), names)));
            } else {
                all.add(each);
            }
        }
        return all;
    }

    /** Whether a variable gets a value in steps. */
    static boolean changes(List<Step> steps, String name) {
        return steps.stream()
                .anyMatch(
                        each ->
                                each instanceof Step.Set set && set.cell().name().equals(name)
                                        || each instanceof Step.Choose choose
                                                && (changes(choose.then(), name)
                                                        || changes(choose.otherwise(), name)));
    }
}
