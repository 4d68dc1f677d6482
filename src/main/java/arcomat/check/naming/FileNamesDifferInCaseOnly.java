package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.Workspace;
import arcomat.tree.Unit;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;

/**
 * ARC0213: no two files differ in upper and lower case only. Some file systems keep only one of
 * them, and of the files generated from them.
 */
public final class FileNamesDifferInCaseOnly implements Check.OnWorkspace {

    @Override
    public Law law() {
        return Law.error("ARC0213");
    }

    @Override
    public void check(Workspace workspace, Findings findings) {
        Map<String, Unit> seen = new HashMap<>();
        for (Unit unit : workspace.units()) {
            String path = unit.file().path();
            Unit first = seen.putIfAbsent(path.toLowerCase(Locale.ROOT), unit);
            if (first != null) {
                findings.report(
                                Definitions.nameOf(unit),
                                "the files '"
                                        + first.file().path()
                                        + "' and '"
                                        + path
                                        + "' differ in upper and lower case only; rename one of"
                                        + " them")
                        .related(Definitions.nameOf(first), "the other file");
            }
        }
    }
}
