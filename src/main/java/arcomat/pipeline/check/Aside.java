package arcomat.pipeline.check;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * What a command goes on without.
 *
 * @param findings about those of the files that have some
 * @param files with errors, and those that need them; ordered
 * @param words of their texts, and their names
 */
public record Aside(List<Diagnostic> findings, List<String> files, Set<String> words) {
    public static final Aside NOTHING = new Aside(List.of(), List.of(), Set.of());

    public Aside {
        findings = List.copyOf(findings);
        files = List.copyOf(files);
        words = Set.copyOf(words);
    }

    static Aside of(List<SourceFile> sources, List<Diagnostic> findings) {
        Set<String> files = new TreeSet<>();
        Set<String> words = new TreeSet<>();
        for (SourceFile file : sources) {
            files.add(file.path());
            words.add(WholeFiles.simpleName(file.path()));
            words.addAll(WrittenNames.in(file.text()));
        }
        return new Aside(findings, List.copyOf(files), words);
    }

    public boolean isEmpty() {
        return files.isEmpty();
    }

    /** What is left out of both. */
    public Aside and(Aside other) {
        Set<Diagnostic> all = new TreeSet<>(Diagnostic.ORDER);
        all.addAll(findings);
        all.addAll(other.findings);
        Set<String> paths = new TreeSet<>(files);
        paths.addAll(other.files);
        Set<String> mentioned = new TreeSet<>(words);
        mentioned.addAll(other.words);
        return new Aside(List.copyOf(all), List.copyOf(paths), mentioned);
    }
}
