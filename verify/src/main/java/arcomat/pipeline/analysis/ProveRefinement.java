package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.NoRun;
import arcomat.analysis.map.InterfaceMap;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.picture.DiagramFile;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Asks whether one component refines another; of components with features that nobody chooses, in
 * all configurations.
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
        implements ModelQuestion<List<Answered>> {
    @Override
    public Asked asked() {
        return sides.asked(map);
    }

    @Override
    public List<Answered> answer(LoweredModels models, Session session) throws WrongUse {
        DiagramFile.requireKnown(diagram);
        ComparedConfigurations compared = ComparedConfigurations.of(sides, models);
        List<List<Promise>> pairs = new ArrayList<>();
        for (ComparedSides pair : compared.pairs()) {
            for (Promise left : pair.lefts(models)) {
                pairs.add(List.of(left, pair.right(models, left)));
            }
        }
        if (pairs.size() == 1 && compared.alone().isEmpty()) {
            return List.of(answer(pairs.get(0), prover, limits.budget(), models, session));
        }
        if (!prover.asksMany() || diagram.isPresent()) {
            throw new WrongUse(
                    "'%s' and '%s' are several questions, such as whether '%s' refines '%s', and"
                            + " this is about one; choose all features and arguments",
                    sides.left(),
                    sides.right(),
                    pairs.isEmpty() ? sides.left() : pairs.get(0).get(0).title(),
                    pairs.isEmpty() ? sides.right() : pairs.get(0).get(1).title());
        }
        return each(pairs, compared.alone(), models, session);
    }

    /** One question for each pair, within limits that are those of all. */
    private List<Answered> each(
            List<List<Promise>> pairs, List<String> alone, LoweredModels models, Session session)
            throws WrongUse {
        Budget budget = limits.budget();
        List<Answered> answers = new ArrayList<>();
        for (List<Promise> pair : pairs) {
            answers.add(answer(pair, new Prover.Within(budget), budget, models, session));
        }
        for (String each : alone) {
            Promise left = sides.of(each, sides.right()).left(models);
            String reason =
                    "no configuration of '%s' chooses the features that both have in this way"
                            .formatted(sides.right());
            Verdict verdict = Verdict.unknown(reason);
            answers.add(
                    new Answered(left.title(), sides.right(), left.component().span(), verdict));
        }
        return answers;
    }

    private Answered answer(
            List<Promise> compared,
            Prover decider,
            Budget budget,
            LoweredModels models,
            Session session)
            throws WrongUse {
        Promise left = compared.get(0);
        Promise right = compared.get(1);
        if (map.isPresent()) {
            InterfaceMap through = new MapReference(map.get()).in(models);
            session.progress().step("comparing");
            Verdict verdict = new NoRun(budget).noted(left, through.check(left, right, budget));
            String title = right.title() + " through " + through.title();
            return answered(left, title, verdict, through.sides(left, right), session);
        }
        session.progress().step("comparing");
        Verdict decided = decider.about(models).decide(left, right, limits, session.names());
        Verdict verdict = new NoRun(budget).noted(left, decided);
        return answered(left, right.title(), verdict, compared, session);
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
