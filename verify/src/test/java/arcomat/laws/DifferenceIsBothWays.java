package arcomat.laws;

import arcomat.analysis.refinement.Difference;
import arcomat.analysis.refinement.Difference.Relation;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.laws.draw.Draw;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.List;

/** {@code diff} says what {@code refines} says, one way and the other. */
final class DifferenceIsBothWays implements Law {

    @Override
    public String name() {
        return "3 diff is refines both ways";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return Pairs.draw(draw);
    }

    @Override
    public Outcome check(Models models) {
        Promise left = Questions.promise(models.component(Pairs.LEFT));
        Promise right = Questions.promise(models.component(Pairs.RIGHT));
        Verdict forward = Questions.refines(left, right);
        Verdict backward = Questions.refines(right, left);
        Relation relation = Difference.of(left, right, Questions.budget()).relation();
        if (forward.answer() == Answer.UNKNOWN
                || backward.answer() == Answer.UNKNOWN
                || relation == Relation.UNKNOWN) {
            return Outcome.SKIPPED;
        }
        boolean there = relation == Relation.EQUIVALENT || relation == Relation.REFINES;
        boolean back = relation == Relation.EQUIVALENT || relation == Relation.IS_REFINED_BY;
        return there == Questions.holds(forward) && back == Questions.holds(backward)
                ? Outcome.KEPT
                : Outcome.broken(
                        "diff says something else than refines",
                        Questions.command(Pairs.LEFT, Pairs.RIGHT) + ": " + Questions.text(forward),
                        Questions.command(Pairs.RIGHT, Pairs.LEFT)
                                + ": "
                                + Questions.text(backward),
                        "diff " + Pairs.LEFT + " " + Pairs.RIGHT + ": " + relation);
    }
}
