package arcomat.pipeline.check;

import arcomat.pipeline.PathNames;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The files behind a set of paths, parsed.
 *
 * @param named paths of the files that the user named, by file or by folder
 * @param sources all files that could be read, in that order
 * @param units the trees of all files that parse, files that others need included
 * @param recovered what could be read of files that do not parse
 * @param broken paths of the files that could not be read or parsed
 * @param findings about reading and parsing
 * @param needed paths of the files that were read only because others may refer to them
 * @param libraries those of them that lie in libraries of the session
 */
public record LoadedModels(
        List<String> named,
        List<SourceFile> sources,
        List<Unit> units,
        List<Recovered> recovered,
        Set<String> broken,
        List<Diagnostic> findings,
        Set<String> needed,
        Set<String> libraries) {
    public LoadedModels {
        named = List.copyOf(named);
        sources = List.copyOf(sources);
        units = List.copyOf(units);
        recovered = List.copyOf(recovered);
        broken = Set.copyOf(broken);
        findings = List.copyOf(findings);
        needed = Set.copyOf(needed);
        libraries = Set.copyOf(libraries);
    }

    /** The same but for the stream tests, as if there were none. */
    LoadedModels withoutTests() {
        return new LoadedModels(
                named.stream().filter(path -> !isTest(path)).toList(),
                sources.stream().filter(file -> !isTest(file.path())).toList(),
                units.stream().filter(unit -> !isTest(unit.file().path())).toList(),
                recovered.stream().filter(each -> !isTest(each.unit().file().path())).toList(),
                broken.stream().filter(path -> !isTest(path)).collect(Collectors.toSet()),
                findings.stream().filter(each -> !isTest(each.span().file().path())).toList(),
                needed,
                libraries);
    }

    /**
     * The same but for the trees of some files, and of those that need them.
     *
     * @param wrong paths; those of files that could not be read may be among them
     */
    public LoadedModels without(Set<String> wrong) {
        return only(WholeFiles.in(this, wrong));
    }

    /** The same but for the trees of files that need others; what could be read is still there. */
    LoadedModels only(Set<String> whole) {
        return new LoadedModels(
                named,
                sources,
                units.stream().filter(unit -> whole.contains(unit.file().path())).toList(),
                recovered,
                Set.of(),
                findings,
                needed,
                libraries);
    }

    private static boolean isTest(String path) {
        return path.endsWith(".mt");
    }

    /** The model roots of all files that lie where their package says. */
    public Set<Path> roots(PathNames names) {
        Set<Path> roots = new LinkedHashSet<>();
        for (Unit unit : units) {
            ModelRoot.of(unit, names.resolve(unit.file().path())).ifPresent(roots::add);
        }
        return roots;
    }

    /** Whether a file is one of those asked about, and not only needed by them. */
    public boolean isNamedByUser(String path) {
        return !needed.contains(path);
    }

    /** Whether a file belongs to somebody else, who has made code of it. */
    public boolean isOfLibrary(String path) {
        return libraries.contains(path);
    }

    /** Warnings about files that the user did not name are somebody else's business. */
    boolean isShown(Diagnostic finding) {
        return finding.isError() || isNamedByUser(finding.span().file().path());
    }
}
