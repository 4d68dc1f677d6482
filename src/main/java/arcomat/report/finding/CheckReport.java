package arcomat.report.finding;

import arcomat.report.finding.Baseline.Comparison;
import arcomat.report.finding.Reported.Standing;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * What checking files found, sorted by what it means.
 *
 * @param paths all files that were named, those without findings too
 * @param findings that somebody has to look at
 * @param suppressed what the models declare to be meant
 * @param comparison with the baseline, where there is one; its new findings are the findings
 */
public record CheckReport(
        List<String> paths,
        List<Diagnostic> findings,
        List<Suppressed> suppressed,
        Optional<Comparison> comparison) {

    public List<Diagnostic> known() {
        return comparison.map(Comparison::known).orElse(List.of());
    }

    /** All findings in one list, by their places. */
    public List<Reported> reported() {
        List<Reported> all = new ArrayList<>();
        findings.forEach(finding -> all.add(Reported.of(finding, Standing.NEW)));
        known().forEach(finding -> all.add(Reported.of(finding, Standing.KNOWN)));
        suppressed.forEach(
                each ->
                        all.add(
                                new Reported(
                                        each.finding(),
                                        Standing.SUPPRESSED,
                                        each.reason(),
                                        List.of())));
        all.sort(Comparator.comparing(Reported::finding, Diagnostic.ORDER));
        return all;
    }
}
