package arcomat.pipeline.analysis;

import arcomat.analysis.map.InterfaceMap;
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
 * @param map component that says how the ports of the left side stand for those of the right one;
 *     then the prover is not asked
 * @param diagram file for a picture of how it fails, where it does
 */
public record ProveRefinement(
        ComparedSides sides,
        Prover prover,
        Optional<String> map,
        Optional<String> diagram,
        List<String> paths,
        AnalysisLimits limits)
        implements ModelQuestion<Answered> {
    @Override
    public Asked asked() {
        return sides.asked(map);
    }

    @Override
    public Answered answer(LoweredModels models, Session session) throws WrongUse {
        Promise left = sides.left(models);
        Promise right = sides.right(models);
        DiagramFile.requireKnown(diagram);
        if (map.isPresent()) {
            InterfaceMap through = new MapReference(map.get()).in(models);
            session.progress().step("comparing");
            Verdict verdict = through.check(left, right, limits.budget());
            String title = right.title() + " through " + through.title();
            return answered(left, title, verdict, through.sides(left, right), session);
        }
        session.progress().step("comparing");
        Verdict verdict = prover.decide(left, right, limits, session.names());
        return answered(left, right.title(), verdict, List.of(left, right), session);
    }

    private Answered answered(
            Promise left, String right, Verdict verdict, List<Promise> compared, Session session)
            throws WrongUse {
        if (diagram.isPresent() && !verdict.trace().isEmpty()) {
            DiagramFile.write(
                    diagram.get(),
                    FailurePicture.of(compared.get(0), compared.get(1), verdict),
                    session.names());
        }
        return new Answered(left.title(), right, left.component().span(), verdict, compared);
    }
}
