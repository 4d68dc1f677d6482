package arcomat.pipeline.analysis;

import arcomat.analysis.mona.InclusionProblem;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.MonaRefinement;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.generate.MonaText;
import arcomat.model.Model;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Puts the question whether one component refines another to the program MONA. */
public final class MonaStep {
    /** Nobody waits longer for an answer, unless he says so. */
    private static final int PATIENCE = 60;

    private MonaStep() {}

    /** Writes the question; its file is replaced at once or not at all. */
    public static MonaResult run(
            RefinesRequest request,
            String out,
            List<String> paths,
            PathNames names,
            Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(
                        paths,
                        Asked.components(List.of(request.left(), request.right())),
                        names,
                        progress);
        if (checked.hasErrors()) {
            return new MonaResult(checked.result(), Optional.empty(), Optional.empty());
        }
        Model model = checked.lower(progress);
        Promise left =
                RefinesStep.promise(request.left(), request.leftCompletion(), checked, model);
        Promise right =
                RefinesStep.promise(request.right(), request.rightCompletion(), checked, model);
        progress.step("spelling the question out");
        MonaRefinement refinement = MonaRefinement.of(left, right, request.limits().budget());
        if (refinement.settled().isPresent()) {
            Answered answered =
                    new Answered(
                            left.title(),
                            right.title(),
                            left.component().span(),
                            refinement.settled().get());
            return new MonaResult(checked.result(), Optional.of(answered), Optional.empty());
        }
        String text = MonaText.render(refinement.formula());
        write(text, out, names);
        InclusionProblem question = refinement.question().orElseThrow();
        return new MonaResult(
                checked.result(),
                Optional.empty(),
                Optional.of(
                        new MonaResult.Written(
                                out, question.leftStates(), question.rightStates())));
    }

    private static void write(String text, String out, PathNames names) throws WrongUse {
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
            throw new WrongUse("cannot write '" + out + "': " + Failures.reason(e));
        }
    }

    /** The program's answer to the question. */
    static Verdict verdict(Promise left, Promise right, RefinesRequest request, PathNames names)
            throws WrongUse {
        Budget budget = request.limits().budget();
        MonaRefinement refinement = MonaRefinement.of(left, right, budget);
        if (refinement.settled().isPresent()) {
            return refinement.settled().get();
        }
        String text = MonaText.render(refinement.formula());
        String spent = budget.exhausted(0);
        if (spent != null) {
            return refinement.unknown(spent);
        }
        MonaAnswer answer =
                MonaProgram.find(request.mona().orElseThrow(), names)
                        .decide(text, request.limits().secondsLeft().orElse(PATIENCE));
        if (answer instanceof MonaAnswer.Counterexample counterexample) {
            return refinement.fails(counterexample.rows());
        }
        return answer instanceof MonaAnswer.None none
                ? refinement.unknown(none.reason())
                : refinement.holds();
    }
}
