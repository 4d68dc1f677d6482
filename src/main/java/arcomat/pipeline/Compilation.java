package arcomat.pipeline;

import java.util.List;

/**
 * What became of some Java files.
 *
 * @param classes of the files without a mistake, in the order of the files
 * @param mistakes in the order of the files
 */
record Compilation(List<CompiledClass> classes, List<Mistake> mistakes) {

    /**
     * @param name internal name
     * @param source path of the file that it comes from
     */
    record CompiledClass(String name, byte[] bytes, String source) {}

    /**
     * A place where a file is not Java 6, or refers to what is not there.
     *
     * @param source path of the file
     * @param start offset in the file
     * @param end behind the last character
     */
    record Mistake(String source, int line, int start, int end, String message) {}

    Compilation {
        classes = List.copyOf(classes);
        mistakes = List.copyOf(mistakes);
    }
}
