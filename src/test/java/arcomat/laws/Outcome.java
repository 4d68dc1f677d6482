package arcomat.laws;

import java.util.List;
import java.util.Map;

/**
 * What became of a law on some models.
 *
 * @param met whether its premise was met, so that it said something
 * @param problem how it is broken; empty if it is kept
 * @param commands those that disagree, without the folder of the models
 * @param tests stream tests that the commands name, by path
 */
record Outcome(boolean met, String problem, List<String> commands, Map<String, String> tests) {
    static final Outcome SKIPPED = new Outcome(false, "", List.of(), Map.of());
    static final Outcome KEPT = new Outcome(true, "", List.of(), Map.of());

    static Outcome broken(String problem, String... commands) {
        return new Outcome(true, problem, List.of(commands), Map.of());
    }

    Outcome with(String path, String text) {
        return new Outcome(met, problem, commands, Map.of(path, text));
    }

    boolean isBroken() {
        return !problem.isEmpty();
    }
}
