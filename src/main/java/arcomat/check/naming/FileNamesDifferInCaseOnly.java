package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.Workspace;

import java.util.Locale;

/**
 * ARC0213: no two files differ in upper and lower case only. Some file systems keep only one of
 * them, and of the files generated from them.
 */
public final class FileNamesDifferInCaseOnly implements Check.OnWorkspace {

    @Override
    public void check(Workspace workspace, Findings findings) {
        Duplicates.report(
                workspace.units(),
                unit -> unit.file().path().toLowerCase(Locale.ROOT),
                (unit, first) ->
                        findings.report(
                                        Definitions.nameOf(unit),
                                        "the files '%s' and '%s' differ in upper and lower case"
                                                + " only; rename one of them",
                                        first.file().path(),
                                        unit.file().path())
                                .related(Definitions.nameOf(first), "the other file"));
    }
}
