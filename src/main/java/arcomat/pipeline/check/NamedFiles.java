package arcomat.pipeline.check;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.file.FileFinder.Found;
import arcomat.pipeline.file.FileReader;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * The files that the user named, by file or by folder, read but not parsed, with those of
 * libraries.
 *
 * @param paths as they are shown
 * @param ofLibraries paths of models of others, of which only errors are told
 * @param readable by their paths, in the same order
 * @param findings about finding and reading
 */
public record NamedFiles(
        List<String> paths,
        List<String> ofLibraries,
        Map<String, SourceFile> readable,
        List<Diagnostic> findings) {

    /**
     * Finds and reads, several files at a time.
     *
     * @param endings of files that guests read
     * @param reader of a file, called by several threads
     */
    public static NamedFiles read(
            List<String> written,
            List<String> libraries,
            List<String> endings,
            PathNames names,
            Progress progress,
            Function<Found, FileReader.Read> reader) {
        FoundModels found = FoundModels.find(written, libraries, endings, names);
        List<Found> files = found.all();
        progress.step("reading", files.size(), "file");
        Map<String, SourceFile> readable = new LinkedHashMap<>();
        List<Diagnostic> findings = new ArrayList<>(found.findings());
        List<FileReader.Read> results = files.parallelStream().map(reader).toList();
        for (int i = 0; i < results.size(); i++) {
            String shown = files.get(i).shown();
            results.get(i).file().ifPresent(file -> readable.put(shown, file));
            results.get(i).finding().ifPresent(findings::add);
        }
        return new NamedFiles(found.paths(), found.pathsOfLibraries(), readable, findings);
    }

    /** The paths of all. */
    public List<String> all() {
        List<String> all = new ArrayList<>(paths);
        all.addAll(ofLibraries);
        return all;
    }

    public boolean hasErrors() {
        return findings.stream().anyMatch(Diagnostic::isError);
    }

    /** The text of a file; empty where it could not be read, or was not named. */
    public SourceFile source(String path) {
        SourceFile file = readable.get(path);
        return file == null ? new SourceFile(path, "") : file;
    }
}
