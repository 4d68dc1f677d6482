package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.explored.ExploredFolder;
import arcomat.pipeline.file.Failures;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;

/**
 * Where what is explored is kept in files instead of memory, to be gone on with.
 *
 * @param folder as the user wrote it
 * @param version of the tool
 */
public record Disk(String folder, String version) {
    /**
     * Asks something while the folder is used.
     *
     * @param <T> the answer
     */
    interface Question<T> {
        T ask(ExploredFolder explored) throws IOException;
    }

    /** Opens the folder. */
    private interface Opening {
        ExploredFolder open() throws WrongUse;
    }

    /** There, nothing but the disk limits how much is explored; only that search is asked. */
    Budget budget(AnalysisLimits limits) {
        return limits.beyondMemory().with(rule -> rule != Shortcut.SYMBOLIC);
    }

    /** Whether one component refines another. */
    Verdict ofRefinement(
            Promise left,
            Promise right,
            LoweredModels models,
            PathNames names,
            Question<Verdict> question)
            throws WrongUse {
        return asked(
                () ->
                        ExploredFolder.ofRefinement(
                                folder, left, right, sources(models), version, names),
                question);
    }

    /** What models promise. */
    <T> T ofPromises(LoweredModels models, PathNames names, Question<T> question) throws WrongUse {
        return asked(
                () -> ExploredFolder.ofPromises(folder, sources(models), version, names), question);
    }

    private static List<SourceFile> sources(LoweredModels models) {
        return models.checked().loaded().sources();
    }

    private <T> T asked(Opening opening, Question<T> question) throws WrongUse {
        try (ExploredFolder explored = opening.open()) {
            return question.ask(explored);
        } catch (UncheckedIOException failed) {
            throw ExploredFolder.failure(folder, failed);
        } catch (IOException unclosed) {
            throw Failures.cannot("write to", folder, unclosed);
        }
    }
}
