package arcomat.pipeline.check;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileReader;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * The files that the user named, by file or by folder, read but not parsed.
 *
 * @param paths as they are shown
 * @param readable by their paths, in the same order
 * @param findings about finding and reading
 */
public record NamedFiles(
        List<String> paths, Map<String, SourceFile> readable, List<Diagnostic> findings) {

    /**
     * Finds and reads, several files at a time.
     *
     * @param reader of a file, called by several threads
     */
    public static NamedFiles read(
            List<String> written,
            PathNames names,
            Progress progress,
            Function<FileFinder.Found, FileReader.Read> reader) {
        FileFinder finder = new FileFinder(names);
        written.forEach(finder::find);
        progress.step("reading", finder.files().size(), "file");
        List<String> paths = new ArrayList<>();
        Map<String, SourceFile> readable = new LinkedHashMap<>();
        List<Diagnostic> findings = new ArrayList<>(finder.findings());
        List<FileReader.Read> results = finder.files().parallelStream().map(reader).toList();
        for (int i = 0; i < results.size(); i++) {
            String shown = finder.files().get(i).shown();
            paths.add(shown);
            results.get(i).file().ifPresent(file -> readable.put(shown, file));
            results.get(i).finding().ifPresent(findings::add);
        }
        return new NamedFiles(paths, readable, findings);
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
