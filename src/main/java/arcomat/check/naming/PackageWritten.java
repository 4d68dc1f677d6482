package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.symbols.Workspace;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** ARC0221: in a folder of a package each file names the package. */
public final class PackageWritten implements Check.OnWorkspace {

    @Override
    public void check(Workspace workspace, Findings findings) {
        Map<String, List<Unit>> folders =
                workspace.units().stream()
                        .collect(Collectors.groupingBy(unit -> folder(unit.file().path())));
        folders.values().forEach(units -> check(units, findings));
    }

    /** Where others do not agree, nobody knows which package is meant. */
    private static void check(List<Unit> units, Findings findings) {
        List<Unit> without = units.stream().filter(each -> each.packageName().isEmpty()).toList();
        List<Unit> with =
                units.stream()
                        .filter(each -> each.packageName().isPresent())
                        .filter(PackageIsFolder::holds)
                        .toList();
        boolean agree = with.stream().map(Unit::packageText).distinct().count() == 1;
        if (agree && PackageIsFolder.isKnown(with.get(0))) {
            without.forEach(each -> report(each, with.get(0), findings));
        }
    }

    private static void report(Unit unit, Unit other, Findings findings) {
        String line = "package " + other.packageText() + ";";
        findings.report(
                        Definitions.nameOf(unit),
                        "the file has no package, and files beside it have; write '%s' above",
                        line)
                .related(other.packageName().orElseThrow(), "a file beside it")
                .fix(Fix.replace("Insert '" + line + "'", unit.file().span(0, 0), line + "\n\n"));
    }

    private static String folder(String path) {
        return path.substring(0, path.lastIndexOf('/') + 1);
    }
}
