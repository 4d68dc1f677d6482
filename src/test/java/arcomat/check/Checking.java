package arcomat.check;

import arcomat.check.law.Profile;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Text in, review out: what the tests of this room need of the rooms below. */
final class Checking {
    private Checking() {}

    static Review review(List<SourceFile> files, Profile profile) {
        return Checks.review(LawBook.OWN, workspace(files), profile, unit -> true, () -> {});
    }

    static Workspace workspace(List<SourceFile> files) {
        List<Unit> units = new ArrayList<>();
        for (SourceFile file : files) {
            Parsed parsed = Parser.parse(file);
            if (!parsed.findings().isEmpty()) {
                throw new AssertionError(syntaxError(parsed.findings().get(0)));
            }
            units.add(parsed.unit().orElseThrow());
        }
        return Workspace.of(units, Set.of(), HouseLanguages.reader());
    }

    private static String syntaxError(Diagnostic finding) {
        return finding.span() + ": " + finding.code() + " " + finding.message();
    }
}
