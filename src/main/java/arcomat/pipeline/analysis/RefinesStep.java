package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.diagram.Graph;
import arcomat.model.Automaton.Completion;
import arcomat.model.Model;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.pipeline.picture.DiagramFile;
import arcomat.pipeline.picture.FailurePicture;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;

import java.util.List;
import java.util.Optional;

/** Compares two components. */
public final class RefinesStep {
    private RefinesStep() {}

    public static AnalysisResult run(
            RefinesRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(
                        paths,
                        Asked.components(List.of(request.left(), request.right())),
                        names,
                        progress);
        if (checked.hasErrors()) {
            return new AnalysisResult(checked.result(), List.of());
        }
        Model model = checked.lower(progress);
        Promise left = promise(request.left(), request.leftCompletion(), checked, model);
        Promise right = promise(request.right(), request.rightCompletion(), checked, model);
        DiagramFile.requireKnown(request.diagram());
        progress.step("comparing");
        Verdict verdict = verdict(left, right, request, names);
        if (request.diagram().isPresent() && !verdict.trace().isEmpty()) {
            Graph failure = FailurePicture.of(left, right, verdict);
            DiagramFile.write(request.diagram().get(), failure, names);
        }
        return new AnalysisResult(
                checked.result(),
                List.of(
                        new Answered(
                                left.title(),
                                right.title(),
                                left.component().span(),
                                verdict,
                                List.of(left, right))));
    }

    private static Verdict verdict(
            Promise left, Promise right, RefinesRequest request, PathNames names) throws WrongUse {
        if (request.mona().isPresent()) {
            if (request.certificate().isPresent() || request.doubted().isPresent()) {
                throw new WrongUse("MONA knows no certificates; leave '--engine mona' out");
            }
            return MonaStep.verdict(left, right, request, names);
        }
        if (request.doubted().isPresent()) {
            return CertificateFile.verify(
                    request.doubted().get(), left, right, request.limits(), names);
        }
        if (request.certificate().isPresent()) {
            CertificateFile.requireReplaceable(request.certificate().get(), names);
            Certification certification = Certification.of(left, right, request.limits().budget());
            CertificateFile.write(request.certificate().get(), left, right, certification, names);
            return certification.verdict();
        }
        return Refinement.check(left, right, request.limits().budget());
    }

    static Promise promise(
            String written, Optional<Completion> completion, CheckedModels checked, Model model)
            throws WrongUse {
        Promise promise = PromiseReference.parse(written).in(checked, model);
        return completion.isPresent() ? promise.with(completion.get()) : promise;
    }
}
