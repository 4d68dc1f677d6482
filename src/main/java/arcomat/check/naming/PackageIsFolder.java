package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.source.ComposedForm;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;
import arcomat.tree.Unit;

import java.util.Arrays;
import java.util.List;

/**
 * ARC0208: a file lies in the folder that its package names. Of a path as the user wrote it only
 * the folders that it names can be compared.
 */
public final class PackageIsFolder implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        List<String> folders = folders(unit.file().path());
        unit.packageName()
                .filter(name -> !endsWith(folders, name.parts()))
                .ifPresent(name -> report(name, folders, findings));
    }

    /** Whether a file lies in the folder of its package, as far as its folders are known. */
    static boolean holds(Unit unit) {
        return unit.packageName()
                .filter(name -> endsWith(folders(unit.file().path()), name.parts()))
                .isPresent();
    }

    /** Whether anything is known of the folders of a file. */
    static boolean isKnown(Unit unit) {
        return !folders(unit.file().path()).isEmpty();
    }

    private static void report(QualifiedName name, List<String> folders, Findings findings) {
        int depth = Math.min(folders.size(), name.parts().size());
        String lies = String.join("/", folders.subList(folders.size() - depth, folders.size()));
        findings.report(
                name,
                "package '%s' belongs in the folder '%s', but the file lies in '%s'; move the file"
                        + " or change the package",
                name,
                name.text().replace('.', '/'),
                lies);
    }

    /** As far as both go. */
    private static boolean endsWith(List<String> folders, List<Name> parts) {
        List<String> names = parts.stream().map(Name::text).toList();
        int depth = Math.min(folders.size(), names.size());
        return folders.subList(folders.size() - depth, folders.size())
                .equals(names.subList(names.size() - depth, names.size()));
    }

    /** The folders of a path whose names are known: those behind the last dots. */
    private static List<String> folders(String path) {
        List<String> parts = Arrays.asList(ComposedForm.of(path).split("/+"));
        List<String> folders = parts.subList(0, parts.size() - 1);
        int unknown = Math.max(folders.lastIndexOf("."), folders.lastIndexOf(".."));
        return folders.subList(unknown + 1, folders.size());
    }
}
