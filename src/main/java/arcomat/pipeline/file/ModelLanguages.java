package arcomat.pipeline.file;

import java.nio.file.Path;
import java.util.List;

/** The endings by which files of models are known. */
public final class ModelLanguages {
    static final List<String> ENDINGS = List.of(".arc", ".cd", ".ioautomaton", ".mt");

    private ModelLanguages() {}

    /** By the ending of the name. */
    public static boolean isModelFile(Path file) {
        String name = file.getFileName().toString();
        return ENDINGS.stream().anyMatch(name::endsWith);
    }

    /** For messages: {@code .arc, .cd, .ioautomaton, .mt}. */
    static String listing() {
        return String.join(", ", ENDINGS);
    }
}
