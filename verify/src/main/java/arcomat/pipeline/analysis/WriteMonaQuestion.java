package arcomat.pipeline.analysis;

import arcomat.analysis.mona.InclusionProblem;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.MonaRefinement;
import arcomat.generate.MonaText;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.semantics.Promise;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes the question whether one component refines another as a text for the program MONA.
 *
 * @param out the file to be written, at once or not at all
 */
public record WriteMonaQuestion(
        ComparedSides sides, String out, List<String> paths, AnalysisLimits limits)
        implements ModelQuestion<WriteMonaQuestion.Outcome> {
    /** What became of it. */
    public sealed interface Outcome {}

    /** The program need not or cannot be asked, and nothing is written. */
    public record Settled(Answered answered) implements Outcome {}

    /**
     * A text that is written.
     *
     * @param leftStates how many states of the left side are spelled out
     */
    public record Written(String file, int leftStates, int rightStates) implements Outcome {}

    @Override
    public Asked asked() {
        return sides.asked();
    }

    /**
     * @throws WrongUse where there are no such components, or the file cannot be written
     */
    @Override
    public Outcome answer(LoweredModels models, Session session) throws WrongUse {
        Promise left = sides.left(models);
        Promise right = sides.right(models);
        session.progress().step("spelling the question out");
        MonaRefinement refinement = MonaRefinement.of(left, right, limits.budget());
        if (refinement.settled().isPresent()) {
            return new Settled(
                    new Answered(
                            left.title(),
                            right.title(),
                            left.component().span(),
                            refinement.settled().get()));
        }
        write(MonaText.render(refinement.formula()), session.names());
        InclusionProblem question = refinement.question().orElseThrow();
        return new Written(out, question.leftStates(), question.rightStates());
    }

    private void write(String text, PathNames names) throws WrongUse {
        Path file = names.resolve(out);
        if (Files.isDirectory(file)) {
            throw new WrongUse("'" + out + "' is a folder; --out names a file");
        }
        try {
            if (Files.exists(file) && !MonaText.isQuestion(Files.readString(file))) {
                throw new WrongUse(
                        "'" + out + "' is there and is no question for MONA; name another file");
            }
            AtomicFile.write(file, text);
        } catch (IOException e) {
            throw Failures.cannot("write", out, e);
        }
    }
}
