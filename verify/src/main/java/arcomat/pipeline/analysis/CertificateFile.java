package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.NoRun;
import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.InvariantCertification;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.Certificate;
import arcomat.model.Invariant;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.report.verdict.CertificateText;
import arcomat.report.verdict.CertificateText.Proof;
import arcomat.semantics.Promise;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * The proof of a refinement as a file, for whoever doubts the tool.
 *
 * @param written the file, as the user wrote it
 */
record CertificateFile(String written, PathNames names) {
    /** Whatever is in the file is lost; it had better be certificates. */
    void requireReplaceable() throws WrongUse {
        Path path = names.resolve(written);
        if (Files.isDirectory(path)) {
            throw new WrongUse("'" + written + "' is a folder; --certificate names a file");
        }
        if (Files.exists(path)) {
            try {
                read();
            } catch (WrongUse other) {
                throw new WrongUse(
                        "'%s' is there and is no file of certificates; name another file", written);
            }
        }
    }

    /** Nothing is written where the refinement does not hold, or nothing shows why. */
    void write(Promise left, Promise right, Certification proof) throws WrongUse {
        if (!proof.certificates().isEmpty()) {
            List<String> remarks = NoRun.notes(proof.verdict());
            write(
                    CertificateText.render(
                            left.title(), right.title(), remarks, proof.certificates()));
        }
    }

    /** Nothing is written where nothing is proved. */
    void write(List<Proof> proofs) throws WrongUse {
        if (!proofs.isEmpty()) {
            write(CertificateText.render(proofs));
        }
    }

    private void write(String text) throws WrongUse {
        try {
            AtomicFile.write(names.resolve(written), text);
        } catch (IOException e) {
            throw Failures.cannot("write to", written, e);
        }
    }

    /** Holds, or unknown where the file proves nothing. */
    Verdict verify(Promise left, Promise right, Budget budget) throws WrongUse {
        List<Proof> about =
                about(PromiseProver.title(left, right), read(), proof -> proof.title().isEmpty());
        return verifyOne(
                about, certificates -> Certification.problem(left, right, certificates, budget));
    }

    /** Verifies what models promise by what stands in the file. */
    PromiseProver verifier() throws WrongUse {
        return new Verifier(this, read());
    }

    private record Verifier(CertificateFile file, List<Proof> proofs) implements PromiseProver {
        @Override
        public Verdict refines(Promise left, Promise right, Budget budget) {
            return file.verifyOne(
                    about(PromiseProver.title(left, right), proofs, proof -> false),
                    proof -> Certification.problem(left, right, proof, budget));
        }

        @Override
        public Verdict keeps(Promise side, Invariant invariant, Budget budget) {
            return file.verifyOne(
                    about(PromiseProver.title(side, invariant), proofs, proof -> false),
                    proof -> InvariantCertification.problem(side, invariant, proof, budget));
        }
    }

    private static List<Proof> about(String title, List<Proof> all, Predicate<Proof> orElse) {
        return all.stream()
                .filter(proof -> proof.title().equals(title) || orElse.test(proof))
                .toList();
    }

    /** Of several with one title, one has to be a proof. */
    private Verdict verifyOne(
            List<Proof> proofs, Function<List<Certificate>, Optional<String>> problem) {
        Verdict verdict = Verdict.unknown("'" + written + "' has no proof of it");
        for (Proof proof : proofs) {
            verdict = verified(proof.certificates(), problem);
            if (verdict.answer() == Answer.HOLDS) {
                return verdict;
            }
        }
        return verdict;
    }

    private Verdict verified(
            List<Certificate> certificates, Function<List<Certificate>, Optional<String>> problem) {
        return Budget.within(
                () ->
                        problem.apply(certificates)
                                .map(
                                        why ->
                                                Verdict.unknown(
                                                        "'" + written + "' is no proof: " + why))
                                .orElseGet(() -> Verdict.proved(certificates)),
                Verdict::unknown);
    }

    private List<Proof> read() throws WrongUse {
        try {
            return CertificateText.parse(Files.readString(names.resolve(written)))
                    .orElseThrow(() -> new WrongUse("'%s' is no file of certificates", written));
        } catch (IOException e) {
            throw Failures.cannot("read", written, e);
        }
    }
}
