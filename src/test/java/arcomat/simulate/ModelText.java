package arcomat.simulate;

import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.models.ModelFiles;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Models from text, for tests: no checks are run. */
final class ModelText {
    private ModelText() {}

    /** All models and tests under a folder. */
    static Model read(Path folder) {
        return read(folder, Map.of());
    }

    /** All models and tests under a folder, and further texts by path. */
    static Model read(Path folder, Map<String, String> texts) {
        List<SourceFile> sources = new ArrayList<>(ModelFiles.of(folder));
        texts.forEach((path, text) -> sources.add(new SourceFile(path, text)));
        return lower(sources);
    }

    private static Model lower(List<SourceFile> sources) {
        List<Unit> units = new ArrayList<>();
        for (SourceFile source : sources) {
            Parsed parsed = Parser.parse(source);
            units.add(
                    parsed.unit()
                            .orElseThrow(() -> new AssertionError(parsed.findings().toString())));
        }
        return Lowering.lower(Workspace.of(units, Set.of()));
    }
}
