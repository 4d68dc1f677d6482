package arcomat.simulate;

import arcomat.model.Model;
import arcomat.models.ModelFiles;
import arcomat.models.ReadModels;
import arcomat.source.SourceFile;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Models from text, for tests: no checks are run. */
public final class ModelText {
    private ModelText() {}

    /** All models and tests under a folder. */
    public static Model read(Path folder) {
        return read(folder, Map.of());
    }

    /** All models and tests under a folder, and further texts by path. */
    public static Model read(Path folder, Map<String, String> texts) {
        List<SourceFile> sources = new ArrayList<>(ModelFiles.of(folder));
        texts.forEach((path, text) -> sources.add(new SourceFile(path, text)));
        return ReadModels.model(sources);
    }
}
