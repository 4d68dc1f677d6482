package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Certification;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.Certificate;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.verdict.CertificateText;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The proof of a refinement as a file, for whoever doubts the tool. */
final class CertificateFile {
    private CertificateFile() {}

    /** Whatever is in the file is lost; it had better be certificates. */
    static void requireReplaceable(String file, PathNames names) throws WrongUse {
        Path path = names.resolve(file);
        if (Files.isDirectory(path)) {
            throw new WrongUse("'" + file + "' is a folder; --certificate names a file");
        }
        if (Files.exists(path)) {
            try {
                read(file, path);
            } catch (WrongUse other) {
                throw new WrongUse(
                        "'"
                                + file
                                + "' is there and is no file of certificates; name another file");
            }
        }
    }

    /** Nothing is written where the refinement does not hold. */
    static void write(
            String file, Promise left, Promise right, Certification proof, PathNames names)
            throws WrongUse {
        if (proof.verdict().answer() != Answer.HOLDS) {
            return;
        }
        try {
            AtomicFile.write(
                    names.resolve(file),
                    CertificateText.render(left.title(), right.title(), proof.certificates()));
        } catch (IOException e) {
            throw new WrongUse("cannot write to '" + file + "': " + Failures.reason(e));
        }
    }

    /** Holds, or unknown where the file proves nothing. */
    static Verdict verify(
            String file, Promise left, Promise right, AnalysisLimits limits, PathNames names)
            throws WrongUse {
        List<Certificate> certificates = read(file, names.resolve(file));
        Budget budget = limits.budget();
        return Budget.within(
                () ->
                        Certification.problem(left, right, certificates, budget)
                                .map(why -> Verdict.unknown("'" + file + "' is no proof: " + why))
                                .orElseGet(() -> Verdict.proved(certificates)),
                Verdict::unknown);
    }

    private static List<Certificate> read(String file, Path path) throws WrongUse {
        try {
            return CertificateText.parse(Files.readString(path))
                    .orElseThrow(() -> new WrongUse("'" + file + "' is no file of certificates"));
        } catch (IOException e) {
            throw new WrongUse("cannot read '" + file + "': " + Failures.reason(e));
        }
    }
}
