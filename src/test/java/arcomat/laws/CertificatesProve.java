package arcomat.laws;

import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict;
import arcomat.laws.draw.Draw;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;

/** What holds has a certificate that can be verified, and that proves nothing that fails. */
final class CertificatesProve implements Law {
    private static final String THIRD = "c.Main";

    @Override
    public String name() {
        return "2 certificates prove";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        List<SourceFile> files = new ArrayList<>(Pairs.draw(draw));
        List<SourceFile> left =
                files.stream().filter(file -> file.path().startsWith("a/")).toList();
        files.addAll(Pairs.edited(draw, Pairs.moved(left, "a", "c")));
        return files;
    }

    @Override
    public Outcome check(Models models) {
        Promise left = Questions.promise(models.component(Pairs.LEFT));
        Promise right = Questions.promise(models.component(Pairs.RIGHT));
        Promise other = Questions.promise(models.component(THIRD));
        String refines = Questions.command(Pairs.LEFT, Pairs.RIGHT);
        Verdict verdict = Questions.refines(left, right);
        Certification proof = Certification.of(left, right, Questions.budget());
        boolean known =
                verdict.answer() != Verdict.Answer.UNKNOWN
                        && proof.verdict().answer() != Verdict.Answer.UNKNOWN;
        if (known && verdict.answer() != proof.verdict().answer()) {
            return Outcome.broken(
                    "a certificate is asked for, and the answer is another one",
                    refines + ": " + Questions.text(verdict),
                    refines + " --certificate: " + Questions.text(proof.verdict()));
        }
        if (!Questions.holds(proof.verdict())) {
            return Outcome.SKIPPED;
        }
        var problem = Certification.problem(left, right, proof.certificates(), Questions.budget());
        if (problem.isPresent()) {
            return Outcome.broken(
                    "a certificate cannot be verified: " + problem.get(),
                    refines + " --certificate");
        }
        boolean proves =
                Certification.problem(other, right, proof.certificates(), Questions.budget())
                        .isEmpty();
        return proves && Questions.fails(Questions.refines(other, right))
                ? Outcome.broken(
                        "a certificate proves what fails",
                        refines + " --certificate",
                        Questions.command(THIRD, Pairs.RIGHT) + ": fails, but is proved by it")
                : Outcome.KEPT;
    }
}
