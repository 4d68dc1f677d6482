package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Verdict;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.semantics.Promise;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;

/** The program MONA of the machine that the tests run on, if it has one. */
public final class InstalledMona {
    private static final PathNames NAMES = new PathNames(Path.of("").toAbsolutePath());

    /** Other tests run beside it, on a machine that may be slow. */
    private static final AnalysisLimits LIMITS =
            new AnalysisLimits(Optional.of(Duration.ofSeconds(240)), Optional.empty());

    private InstalledMona() {}

    public static boolean isThere() {
        try {
            MonaProgram.find("mona", NAMES);
            return true;
        } catch (WrongUse absent) {
            return false;
        }
    }

    /**
     * What the program says about a refinement. Now and then it crashes on a question that it
     * answers the next time.
     */
    public static Verdict verdict(Promise left, Promise right) {
        Verdict verdict = answer(left, right);
        boolean crashed = verdict.reason().equals("MONA failed with exit status 139");
        return crashed ? answer(left, right) : verdict;
    }

    private static Verdict answer(Promise left, Promise right) {
        try {
            return new Prover.Mona("mona").decide(left, right, LIMITS, NAMES);
        } catch (WrongUse e) {
            throw new AssertionError(e);
        }
    }
}
