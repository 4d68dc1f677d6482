package arcomat.pipeline.gate;

import arcomat.analysis.evolution.Gate;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import java.util.List;
import java.util.Optional;

/**
 * What became of the components of a model.
 *
 * @param base what checking the old models found
 * @param check what checking the new models found
 * @param gate empty where either of them has errors, beside files that are left out
 * @param findings about components: promises that are not kept, reasons that nothing needs; ordered
 * @param meant promises that are not kept for a reason; ordered
 */
public record GateResult(
        CheckResult base,
        CheckResult check,
        Optional<Gate> gate,
        List<Diagnostic> findings,
        List<Suppressed> meant) {
    public GateResult {
        findings = List.copyOf(findings);
        meant = List.copyOf(meant);
    }

    /** What the sides are compared without. */
    public Aside aside() {
        return base.aside().and(check.aside());
    }
}
