package arcomat.pipeline;

import arcomat.analysis.Gate;
import arcomat.source.Diagnostic;

import java.util.List;
import java.util.Optional;

/**
 * What became of the components of a model.
 *
 * @param base what checking the old models found
 * @param check what checking the new models found
 * @param gate empty where either of them has errors
 * @param findings about components: promises that are not kept, reasons that nothing needs; ordered
 */
public record GateResult(
        CheckResult base, CheckResult check, Optional<Gate> gate, List<Diagnostic> findings) {
    public GateResult {
        findings = List.copyOf(findings);
    }
}
