package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.source.ComposedForm;
import arcomat.symbols.Workspace;
import arcomat.tree.Unit;

import java.util.Locale;

/**
 * ARC0213: no two files differ in upper and lower case only, or in how an accent is encoded. Some
 * file systems keep only one of them, and of the files generated from them.
 */
public final class FileNamesDifferInCaseOnly implements Check.OnWorkspace {

    @Override
    public void check(Workspace workspace, Findings findings) {
        Duplicates.report(
                workspace.units(),
                unit -> path(unit).toLowerCase(Locale.ROOT),
                (unit, first) ->
                        findings.report(
                                        Definitions.nameOf(unit),
                                        "the files '%s' and '%s' differ in %s only; rename one of"
                                                + " them",
                                        first.file().path(),
                                        unit.file().path(),
                                        path(first).equals(path(unit))
                                                ? "how accents are encoded"
                                                : "upper and lower case")
                                .related(Definitions.nameOf(first), "the other file"));
    }

    private static String path(Unit unit) {
        return ComposedForm.of(unit.file().path());
    }
}
