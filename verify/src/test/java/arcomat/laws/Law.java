package arcomat.laws;

import arcomat.laws.draw.Draw;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Something that holds between the commands, whatever the models. */
interface Law {
    /** With the number that the law has in {@code docs/testing.md}. */
    String name();

    /** Models to try it on; they may break a context condition, and are not tried then. */
    List<SourceFile> draw(Draw draw);

    Outcome check(Models models);

    /** Empty where the text breaks a context condition. */
    default Optional<Outcome> checkText(List<SourceFile> files, int seed) {
        return Models.read(files, seed).map(this::check);
    }

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
}
