package arcomat.editor.verdict;

import arcomat.pipeline.check.LoadedModels;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Set;

/**
 * The texts that some answers depend on.
 *
 * @param broken paths of those that cannot be read, whatever is in them
 */
record Texts(List<SourceFile> sources, Set<String> broken) {
    static Texts of(LoadedModels models) {
        return new Texts(List.copyOf(models.sources()), models.broken());
    }

    /** Whether they say the same, letter by letter. */
    boolean areThoseOf(Texts others) {
        if (sources.size() != others.sources.size() || !broken.equals(others.broken)) {
            return false;
        }
        for (int i = 0; i < sources.size(); i++) {
            SourceFile one = sources.get(i);
            SourceFile other = others.sources.get(i);
            if (!one.path().equals(other.path()) || !one.text().equals(other.text())) {
                return false;
            }
        }
        return true;
    }
}
