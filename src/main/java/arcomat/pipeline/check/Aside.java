package arcomat.pipeline.check;

import arcomat.source.Diagnostic;

import java.util.List;

/**
 * What a command goes on without.
 *
 * @param findings about those of the files that have some
 * @param files with errors in their syntax, and those that need them; ordered
 */
public record Aside(List<Diagnostic> findings, List<String> files) {
    static final Aside NOTHING = new Aside(List.of(), List.of());

    public Aside {
        findings = List.copyOf(findings);
        files = List.copyOf(files);
    }

    public boolean isEmpty() {
        return files.isEmpty();
    }
}
