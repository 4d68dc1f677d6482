package arcomat.models;

import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Models from text, for tests: the text has no syntax errors, and no checks are run. */
public final class ReadModels {
    private ReadModels() {}

    public static Workspace workspace(List<SourceFile> files) {
        List<Unit> units = new ArrayList<>();
        for (SourceFile file : files) {
            Parsed parsed = Parser.parse(file);
            if (!parsed.findings().isEmpty()) {
                throw new AssertionError(parsed.findings() + "\n" + file.text());
            }
            units.add(parsed.unit().orElseThrow());
        }
        return Workspace.of(units, Set.of(), HouseLanguages.reader());
    }

    public static Model model(SourceFile... files) {
        return model(List.of(files));
    }

    public static Model model(List<SourceFile> files) {
        return Lowering.lower(workspace(files));
    }
}
