package arcomat.pipeline.check;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileFinder.Found;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;

/**
 * The files behind what a user names.
 *
 * @param own what is asked about
 * @param ofLibraries models of others, which those may refer to; nobody refers to a test
 * @param findings about paths that lead nowhere
 */
record FoundModels(List<Found> own, List<Found> ofLibraries, List<Diagnostic> findings) {
    FoundModels {
        own = List.copyOf(own);
        ofLibraries = List.copyOf(ofLibraries);
        findings = List.copyOf(findings);
    }

    /**
     * What is named and lies in a library as well is asked about.
     *
     * @param endings of files that guests read
     */
    static FoundModels find(
            List<String> paths, List<String> libraries, List<String> endings, PathNames names) {
        FileFinder finder = new FileFinder(names, endings);
        paths.forEach(finder::find);
        List<Found> own = List.copyOf(finder.files());
        libraries.forEach(finder::find);
        List<Found> others =
                finder.files().subList(own.size(), finder.files().size()).stream()
                        .filter(file -> !file.shown().endsWith(".mt"))
                        .toList();
        return new FoundModels(own, others, finder.findings());
    }

    List<Found> all() {
        List<Found> all = new ArrayList<>(own);
        all.addAll(ofLibraries);
        return all;
    }

    /** What is asked about, as it is shown. */
    List<String> paths() {
        return own.stream().map(Found::shown).toList();
    }

    /** As above, of libraries. */
    List<String> pathsOfLibraries() {
        return ofLibraries.stream().map(Found::shown).toList();
    }
}
