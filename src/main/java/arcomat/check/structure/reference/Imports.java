package arcomat.check.structure.reference;

import arcomat.check.law.Check.Findings;
import arcomat.source.Fix;
import arcomat.source.Span;
import arcomat.tree.QualifiedName;
import arcomat.tree.Unit;

import java.util.Optional;

/** What to do about a name that exists, but that the file does not reach. */
final class Imports {
    private Imports() {}

    /** Reports a name that one import would explain. */
    static void reportMissing(
            QualifiedName name, String kind, String qualifiedName, Unit unit, Findings findings) {
        String line = "import " + qualifiedName + ";";
        findings.report(name, "%s '%s' is not in sight of this file; add '%s'", kind, name, line);
        findings.fix(insertion(line, unit));
    }

    /** Before the other imports, or else behind the package, or else on top. */
    private static Fix insertion(String line, Unit unit) {
        String title = "Insert '" + line + "'";
        if (!unit.imports().isEmpty()) {
            return Fix.replace(title, at(unit.imports().get(0).span().start(), unit), line + "\n");
        }
        Optional<QualifiedName> packageName = unit.packageName();
        if (packageName.isEmpty()) {
            return Fix.replace(title, at(0, unit), line + "\n\n");
        }
        int end = unit.file().text().indexOf(';', packageName.get().span().end()) + 1;
        return Fix.replace(title, at(end, unit), "\n\n" + line);
    }

    private static Span at(int offset, Unit unit) {
        return unit.file().span(offset, offset);
    }
}
