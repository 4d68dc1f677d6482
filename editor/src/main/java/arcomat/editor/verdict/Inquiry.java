package arcomat.editor.verdict;

import arcomat.pipeline.Interruption;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.pipeline.verdict.AskVerdicts;
import arcomat.pipeline.verdict.TextVerdict;

import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * All questions about one file, while they are being asked.
 *
 * @param path of the file among the models
 * @param interruption ends it when nobody wants to know any longer
 */
record Inquiry(OpenModels models, String path, Interruption interruption) {
    /** For all questions about a file; what is open then is unknown. */
    private static final int SECONDS = 10;

    private static final String ERRORS = "not asked while models have errors";

    Inquiry(OpenModels models, String path) {
        this(models, path, new Interruption());
    }

    boolean isAbout(OpenModels others) {
        return models.edition() == others.edition();
    }

    /**
     * Asks, unless nothing has changed that the answers depend on.
     *
     * @param last what was known before
     * @throws java.util.concurrent.CancellationException where nobody wants to know any longer
     */
    Known ask(Optional<Known> last) {
        LoadedModels around = models.around(path);
        Texts texts = Texts.of(around);
        if (last.isPresent() && last.get().isAbout(texts)) {
            return last.get().now(models.edition());
        }
        List<TextVerdict> before = last.map(Known::verdicts).orElse(List.of());
        try {
            Optional<List<TextVerdict>> verdicts = answer(around).value();
            interruption.goOn();
            return verdicts.map(all -> new Known(models.edition(), texts, all, Optional.empty()))
                    .orElseGet(() -> unanswered(texts, before, ERRORS));
        } catch (WrongUse | StackOverflowError | OutOfMemoryError reason) {
            return unanswered(texts, before, "cannot be asked: " + reason);
        }
    }

    private Known unanswered(Texts texts, List<TextVerdict> before, String reason) {
        return new Known(models.edition(), texts, before, Optional.of(reason));
    }

    private CheckedAnswer<List<TextVerdict>> answer(LoadedModels around) throws WrongUse {
        AnalysisLimits limits =
                new AnalysisLimits(Optional.of(Duration.ofSeconds(SECONDS)), Optional.empty());
        Session session = Session.in(models.root(), interruption).with(models.guests());
        return new AskVerdicts(path, limits, interruption).askAbout(around, session);
    }
}
