package arcomat.laws;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.laws.draw.Draw;
import arcomat.pipeline.analysis.InstalledMona;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.List;

/** The program MONA, where it is installed, says what the engine says. */
final class MonaAgrees implements Law {
    private static final boolean INSTALLED = InstalledMona.isThere();

    @Override
    public String name() {
        return "7 mona agrees";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return Pairs.draw(draw);
    }

    @Override
    public Outcome check(Models models) {
        Promise left = Questions.promise(models.component(Pairs.LEFT));
        Promise right = Questions.promise(models.component(Pairs.RIGHT));
        if (!INSTALLED || left.component().isComposite() || right.component().isComposite()) {
            return Outcome.SKIPPED;
        }
        Verdict own = Questions.refines(left, right);
        Verdict other = InstalledMona.verdict(left, right);
        if (own.answer() == Answer.UNKNOWN || other.answer() == Answer.UNKNOWN) {
            return Outcome.SKIPPED;
        }
        boolean same = own.answer() == other.answer() && own.trace().size() == other.trace().size();
        String refines = Questions.command(Pairs.LEFT, Pairs.RIGHT);
        return same
                ? Outcome.KEPT
                : Outcome.broken(
                        "mona says something else",
                        refines + ": " + Questions.text(own),
                        refines + " --engine mona: " + Questions.text(other));
    }
}
