package arcomat.pipeline.recheck;

import arcomat.guest.host.Guests;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.check.ModelLoader;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileReader;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Parsed;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/**
 * Models of others that open ones may refer to, read once for all roots: nobody changes them here.
 * Nobody refers to their tests.
 */
public final class LibraryModels {
    public static final LibraryModels NONE = new LibraryModels(Set.of(), Map.of(), List.of());

    private static final String SUITE = ".mt";

    private final Set<Path> folders;
    private final Map<String, LibraryFile> files;
    private final List<Diagnostic> missing;

    /**
     * One of them.
     *
     * @param source empty where it cannot be read
     */
    record LibraryFile(Optional<SourceFile> source, Parsed parsed) {}

    private LibraryModels(
            Set<Path> folders, Map<String, LibraryFile> files, List<Diagnostic> missing) {
        this.folders = Set.copyOf(folders);
        this.files = Collections.unmodifiableMap(files);
        this.missing = List.copyOf(missing);
    }

    /**
     * Reads them.
     *
     * @param folders model roots, absolute
     * @param guests who bring laws and behaviour languages
     */
    public static LibraryModels in(List<Path> folders, Guests guests) {
        if (folders.isEmpty()) {
            return NONE;
        }
        Set<Path> real = new HashSet<>();
        FileFinder finder = new FileFinder(new PathNames(folders.get(0)), guests.endings());
        for (Path folder : folders) {
            real.add(PathNames.real(folder));
            finder.find(folder.toString());
        }
        Map<String, LibraryFile> files = new TreeMap<>();
        List<SourceFile> texts = new ArrayList<>();
        for (FileFinder.Found found : finder.files()) {
            if (found.shown().endsWith(SUITE)) {
                continue; // also where it cannot be read
            }
            FileReader.Read read = FileReader.read(found.path(), found.shown());
            read.file().ifPresent(texts::add);
            read.finding().ifPresent(each -> files.put(found.shown(), unreadable(each)));
        }
        List<Parsed> parsed = ModelLoader.parse(texts, guests, Progress.NONE);
        for (int i = 0; i < texts.size(); i++) {
            SourceFile text = texts.get(i);
            files.put(text.path(), new LibraryFile(Optional.of(text), parsed.get(i)));
        }
        return new LibraryModels(real, files, finder.findings());
    }

    private static LibraryFile unreadable(Diagnostic finding) {
        return new LibraryFile(
                Optional.empty(), new Parsed(Optional.empty(), Optional.empty(), List.of(finding)));
    }

    /** By absolute paths, which no file of a root has. */
    Map<String, LibraryFile> files() {
        return files;
    }

    /** The model roots, with their real names. */
    Set<Path> folders() {
        return folders;
    }

    /** About folders that are not there, or hold no models. */
    public List<Diagnostic> findings() {
        return missing;
    }

    /** Whether a file lies in one of the folders. */
    public boolean holds(Path file) {
        return folders.stream().anyMatch(file::startsWith);
    }
}
