package arcomat.cli.option;

import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.BaselineFile;
import arcomat.pipeline.check.CheckResult;
import arcomat.report.finding.Baseline.Comparison;
import arcomat.report.finding.CheckReport;
import arcomat.source.Diagnostic;

import picocli.CommandLine.Option;

import java.util.List;
import java.util.Optional;

/** Findings that an old project lives with, so that only new ones are told. */
public final class BaselineOptions {
    @Option(
            names = "--baseline",
            paramLabel = "FILE",
            description = "Findings in that file are known: they are counted, no more.")
    private String baseline;

    @Option(
            names = "--write-baseline",
            paramLabel = "FILE",
            description = "Write all findings to that file: from now on they are known.")
    private String fresh;

    /** What was found, with the known findings set apart. */
    public CheckReport apply(CheckResult check, Session session) throws WrongUse {
        if (baseline != null && fresh != null) {
            throw new WrongUse(
                    "--baseline reads a file and --write-baseline writes one; give one of them");
        }
        boolean writes = fresh != null && !check.hasUnreadableInput();
        if (writes) {
            new BaselineFile(fresh, session.names()).write(check.findings());
        }
        String file = writes ? fresh : baseline;
        if (file == null) {
            return report(check, check.findings(), Optional.empty());
        }
        Comparison comparison = new BaselineFile(file, session.names()).compare(check);
        return report(check, comparison.fresh(), Optional.of(comparison));
    }

    private static CheckReport report(
            CheckResult check, List<Diagnostic> findings, Optional<Comparison> comparison) {
        return new CheckReport(check.paths(), findings, check.suppressed(), comparison);
    }
}
