package arcomat.pipeline.recheck;

import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;
import arcomat.symbols.names.Outline;

import com.fasterxml.jackson.databind.annotation.JsonDeserialize;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What a check of a set of files leaves behind for the next one.
 *
 * @param key of the tool and of the options; states of other keys are of no use
 * @param folders in which files were looked for by name: a digest of the names that were there
 * @param files all that were looked at, in that order
 */
public record CheckState(String key, Map<String, String> folders, List<File> files) {
    public CheckState {
        folders = Map.copyOf(folders);
        files = List.copyOf(files);
    }

    /**
     * One file.
     *
     * @param path as it is shown
     * @param hash digest of its text; empty where it could not be read
     * @param named whether the user named it, by itself or by its folder
     * @param needs paths of files that it refers to and that the user did not name
     * @param names what it defines; empty where it has no tree
     * @param mentions every name in its text, in that order
     * @param findings at places in this file, but for those about reading it
     */
    public record File(
            String path,
            String hash,
            boolean named,
            List<String> needs,
            Optional<Outline> names,
            @JsonDeserialize(as = LinkedHashSet.class) Set<String> mentions,
            List<Diagnostic> findings,
            List<Suppressed> suppressed) {
        public File {
            needs = List.copyOf(needs);
            findings = List.copyOf(findings);
            suppressed = List.copyOf(suppressed);
        }

        /** The same with what was found now. */
        public File with(List<Diagnostic> found, List<Suppressed> meant) {
            return new File(path, hash, named, needs, names, mentions, found, meant);
        }
    }
}
