package arcomat.plugin;

import java.io.File;
import java.util.Arrays;
import java.util.List;

/** Which files of a model root belong to what others may refer to, wherever it is packed. */
public final class ModelFiles {
    /** Files that others refer to. */
    public static final List<String> MODELS =
            List.of("**/*.arc", "**/*.ioautomaton", "**/*.maa", "**/*.cd");

    /** Code written by hand for platform components, by target: robots of others need it. */
    public static final String PLATFORM = "platform/**";

    /** What tells a jar of models from that of their classes. */
    public static final String CLASSIFIER = "models";

    private ModelFiles() {}

    /** Whether a file of a model root is one of those, by its path from there. */
    public static boolean isForOthers(String path) {
        return isModel(path) || path.startsWith(PLATFORM.replace("**", ""));
    }

    /** The folders in a folder that hold something, in the order of their names. */
    public static List<File> roots(File folder) {
        File[] folders = folder.listFiles(ModelFiles::holdsModels);
        return folders == null ? List.of() : Arrays.stream(folders).sorted().toList();
    }

    private static boolean holdsModels(File file) {
        File[] files = file.listFiles();
        return files == null
                ? isModel(file.getName())
                : Arrays.stream(files).anyMatch(ModelFiles::holdsModels);
    }

    private static boolean isModel(String name) {
        return MODELS.stream()
                .anyMatch(pattern -> name.endsWith(pattern.substring("**/*".length())));
    }
}
