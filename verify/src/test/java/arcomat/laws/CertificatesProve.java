package arcomat.laws;

import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.InvariantCertification;
import arcomat.analysis.refinement.InvariantProof;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.laws.draw.Draw;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

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

    /**
     * An invariant that holds has a certificate that can be verified, and that proves none that
     * fails, whole or without a part of it.
     */
    static final class OfInvariants implements Law {
        private static final String COMMAND = "verify " + Pairs.LEFT;

        @Override
        public String name() {
            return "8 certificates of invariants prove";
        }

        @Override
        public List<SourceFile> draw(Draw draw) {
            return new InvariantsAsTheReference().draw(draw);
        }

        @Override
        public Outcome check(Models models) {
            Component component = models.component(Pairs.LEFT);
            Promise asked = Promise.of(component, List.of());
            List<Certificate> found = new ArrayList<>(List.of(Certificate.ofClauses(List.of())));
            List<Invariant> failing = new ArrayList<>();
            for (Invariant each : component.invariants()) {
                Answer answer =
                        InvariantProof.check(component, List.of(), each, Questions.budget())
                                .answer();
                Certification proof = InvariantCertification.of(asked, each, Questions.budget());
                if (proof.verdict().answer() != answer) {
                    return Outcome.broken(
                            "a certificate is asked for, and the answer is another one", COMMAND);
                }
                if (answer == Answer.FAILS) {
                    failing.add(each);
                }
                if (answer == Answer.HOLDS && !proof.certificates().isEmpty()) {
                    var problem = problem(asked, each, proof.certificates().get(0));
                    if (problem.isPresent()) {
                        return Outcome.broken(
                                "a certificate cannot be verified: " + problem.get(), COMMAND);
                    }
                    found.add(proof.certificates().get(0));
                }
            }
            for (Invariant each : failing) {
                for (Certificate certificate : found) {
                    for (Certificate some : weaker(certificate)) {
                        if (problem(asked, each, some).isEmpty()) {
                            return Outcome.broken(
                                    "a certificate proves what fails: " + some, COMMAND);
                        }
                    }
                }
            }
            return found.size() > 1 ? Outcome.KEPT : Outcome.SKIPPED;
        }

        private static Optional<String> problem(
                Promise asked, Invariant invariant, Certificate certificate) {
            return InvariantCertification.problem(
                    asked, invariant, List.of(certificate), Questions.budget());
        }

        /** The certificate, and without each of its entries. */
        private static List<Certificate> weaker(Certificate certificate) {
            List<Certificate> all = new ArrayList<>(List.of(certificate));
            for (int i = 0; i < certificate.entries().size(); i++) {
                List<Entry> rest = new ArrayList<>(certificate.entries());
                rest.remove(i);
                all.add(new Certificate(certificate.form(), rest));
            }
            return all;
        }
    }
}
