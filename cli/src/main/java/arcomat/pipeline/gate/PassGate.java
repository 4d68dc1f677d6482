package arcomat.pipeline.gate;

import arcomat.analysis.evolution.Gate;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.check.Aside;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedModels;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Compares every component of models with what it was in another model root.
 *
 * @param base the folders with the models as they were: model roots, one at least
 * @param paths the models as they are, of the same model roots
 * @param limits of each single comparison
 */
public record PassGate(List<String> base, List<String> paths, AnalysisLimits limits)
        implements Task<PassGate.Result> {
    /**
     * What became of the components of a model.
     *
     * @param base what checking the old models found
     * @param check what checking the new models found
     * @param gate empty where either of them has errors, beside files that are left out
     * @param findings about components: promises that are not kept, reasons that nothing needs;
     *     ordered
     * @param meant promises that are not kept for a reason; ordered
     */
    public record Result(
            CheckResult base,
            CheckResult check,
            Optional<Gate> gate,
            List<Diagnostic> findings,
            List<Suppressed> meant) {
        /** What the sides are compared without. */
        public Aside aside() {
            return base.aside().and(check.aside());
        }
    }

    /**
     * @throws WrongUse where the base is a part of the new models
     */
    @Override
    public Result run(Session session) throws WrongUse {
        refuseBaseInside(session.names());
        CheckedModels old = CheckedModels.checkWithoutTests(base, session);
        CheckedModels now = CheckedModels.checkWithoutTests(paths, session);
        if (old.hasErrors() || now.hasErrors()) {
            return new Result(old.result(), now.result(), Optional.empty(), List.of(), List.of());
        }
        GateScope scope = new GateScope(old, now, paths, session.names());
        GateSide before = GateSide.of(old.lower(session));
        GateSide after = GateSide.of(now.lower(session));
        BreakReasons reasons = new BreakReasons(before, after);
        Gate gate =
                new GateComparison(before, after, reasons, limits, session.progress()).in(scope);
        GateFindings found = GateFindings.of(gate, before, after, reasons);
        return new Result(
                old.result(), now.result(), Optional.of(gate), found.findings(), found.meant());
    }

    /** The base would be searched as a part of the new models. */
    private void refuseBaseInside(PathNames names) throws WrongUse {
        for (String written : base) {
            for (String path : paths) {
                Path old = PathNames.real(names.resolve(written));
                Path now = PathNames.real(names.resolve(path));
                if (old.startsWith(now) && isSearched(now.relativize(old))) {
                    throw new WrongUse(
                            "the base '%s' is inside '%s'; put the old models into a folder beside"
                                    + " the new ones",
                            written, path);
                }
            }
        }
    }

    private static boolean isSearched(Path inside) {
        for (Path folder : inside) {
            if (folder.toString().startsWith(".")) {
                return false;
            }
        }
        return true;
    }
}
