package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.picture.DiagramFile;
import arcomat.pipeline.picture.FailurePicture;

import java.util.List;
import java.util.Optional;

/**
 * Asks whether one component refines another.
 *
 * @param prover who decides
 * @param diagram file for a picture of how it fails, where it does
 */
public record ProveRefinement(
        ComparedSides sides,
        Prover prover,
        Optional<String> diagram,
        List<String> paths,
        AnalysisLimits limits)
        implements ModelQuestion<Answered> {
    @Override
    public Asked asked() {
        return sides.asked();
    }

    @Override
    public Answered answer(LoweredModels models, Session session) throws WrongUse {
        Promise left = sides.left(models);
        Promise right = sides.right(models);
        DiagramFile.requireKnown(diagram);
        session.progress().step("comparing");
        Verdict verdict = prover.decide(left, right, limits, session.names());
        if (diagram.isPresent() && !verdict.trace().isEmpty()) {
            DiagramFile.write(
                    diagram.get(), FailurePicture.of(left, right, verdict), session.names());
        }
        return new Answered(
                left.title(),
                right.title(),
                left.component().span(),
                verdict,
                List.of(left, right));
    }
}
