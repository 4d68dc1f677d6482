package arcomat.laws;

import arcomat.laws.draw.Draw;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Optional;

/** Something that holds between the commands, whatever the models. */
interface Law {
    /** With the number that the law has in {@code CONTRIBUTING.md}. */
    String name();

    /** Models to try it on; they may break a context condition, and are not tried then. */
    List<SourceFile> draw(Draw draw);

    Outcome check(Models models);

    /** Empty where the text breaks a context condition. */
    default Optional<Outcome> checkText(List<SourceFile> files, int seed) {
        return Models.read(files, seed).map(this::check);
    }
}
