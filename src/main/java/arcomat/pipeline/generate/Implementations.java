package arcomat.pipeline.generate;

import arcomat.generate.Generation;
import arcomat.generate.Target;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Library;
import arcomat.pipeline.file.FileReader;
import arcomat.source.SourceFile;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Code written by hand for a target: the implementations of platform components and whatever they
 * stand on, in the target's folder under a model root. The model library is such a root, too; where
 * both have a file, the user's wins.
 *
 * @param own the user's files by their path below the target's folder
 * @param shipped the library's
 */
public record Implementations(Map<String, SourceFile> own, Map<String, SourceFile> shipped) {

    /**
     * Looks below every model root, for the target and for the one that it is based on.
     *
     * @throws WrongUse where a file cannot be read
     */
    public static Implementations find(Target target, Collection<Path> roots, PathNames names)
            throws WrongUse {
        Map<String, SourceFile> own = new TreeMap<>();
        Map<String, SourceFile> shipped = new TreeMap<>();
        List<Target> targets = new ArrayList<>(List.of(target));
        target.base().ifPresent(targets::add);
        for (Target each : targets) {
            for (Path root : roots) {
                Path folder = root.resolve(each.platformFolder());
                if (Files.isDirectory(folder) && names.fence().permits(folder)) {
                    read(folder, names, own);
                }
            }
            Library.code(each.platformFolder()).forEach(shipped::putIfAbsent);
        }
        return new Implementations(own, shipped);
    }

    private static void read(Path folder, PathNames names, Map<String, SourceFile> own)
            throws WrongUse {
        boolean absolute = !folder.startsWith(names.directory());
        for (Path file : Targets.files(folder, names.shown(folder, absolute))) {
            String shown = names.shown(file, absolute);
            if (!names.fence().permits(file)) {
                throw new WrongUse("'" + shown + "' " + names.fence().refusal());
            }
            String path = folder.relativize(file).toString().replace('\\', '/');
            own.putIfAbsent(path, FileReader.text(file, shown));
        }
    }

    /** The texts of what the user wrote, and beside it what was generated for it. */
    Map<String, String> with(Generation generation) {
        Map<String, String> texts = new LinkedHashMap<>();
        own.forEach((path, file) -> texts.put(path, file.text()));
        generation.files().forEach(file -> texts.put(file.path(), file.text()));
        return texts;
    }

    /** All files; the user's instead of the library's. */
    Map<String, SourceFile> all() {
        Map<String, SourceFile> all = new TreeMap<>(shipped);
        all.putAll(own);
        return all;
    }

    /** The texts of all files. */
    public Map<String, String> texts() {
        Map<String, String> texts = new TreeMap<>();
        all().forEach((path, file) -> texts.put(path, file.text()));
        return texts;
    }
}
