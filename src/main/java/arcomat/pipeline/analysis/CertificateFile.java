package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.Certificate;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.report.verdict.CertificateText;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

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

    /** Nothing is written where the refinement does not hold. */
    void write(Promise left, Promise right, Certification proof) throws WrongUse {
        if (proof.verdict().answer() != Answer.HOLDS) {
            return;
        }
        try {
            AtomicFile.write(
                    names.resolve(written),
                    CertificateText.render(left.title(), right.title(), proof.certificates()));
        } catch (IOException e) {
            throw Failures.cannot("write to", written, e);
        }
    }

    /** Holds, or unknown where the file proves nothing. */
    Verdict verify(Promise left, Promise right, Budget budget) throws WrongUse {
        List<Certificate> certificates = read();
        return Budget.within(
                () ->
                        Certification.problem(left, right, certificates, budget)
                                .map(
                                        why ->
                                                Verdict.unknown(
                                                        "'" + written + "' is no proof: " + why))
                                .orElseGet(() -> Verdict.proved(certificates)),
                Verdict::unknown);
    }

    private List<Certificate> read() throws WrongUse {
        try {
            return CertificateText.parse(Files.readString(names.resolve(written)))
                    .orElseThrow(() -> new WrongUse("'%s' is no file of certificates", written));
        } catch (IOException e) {
            throw Failures.cannot("read", written, e);
        }
    }
}
