package arcomat.editor.verdict;

import arcomat.pipeline.recheck.OpenModels.Edition;
import arcomat.pipeline.verdict.TextVerdict;
import arcomat.pipeline.verdict.VerdictPlace;

import java.util.List;
import java.util.Optional;

/**
 * What is known about a file.
 *
 * @param edition of the models for which it is known
 * @param texts what it depends on
 * @param verdicts the last ones, of earlier texts where there is an obstacle
 * @param obstacle why nothing could be said about these texts
 */
record Known(Edition edition, Texts texts, List<TextVerdict> verdicts, Optional<String> obstacle) {
    Known {
        verdicts = List.copyOf(verdicts);
    }

    boolean isAbout(Texts others) {
        return texts.areThoseOf(others);
    }

    /** The same of models that have changed elsewhere. */
    Known now(Edition later) {
        return new Known(later, texts, verdicts, obstacle);
    }

    Optional<TextVerdict> at(VerdictPlace place) {
        return verdicts.stream().filter(each -> each.place().isSame(place)).findFirst();
    }

    /** Whether the verdicts are about these texts. */
    boolean holdsFor(Edition present) {
        return edition == present && obstacle.isEmpty();
    }
}
