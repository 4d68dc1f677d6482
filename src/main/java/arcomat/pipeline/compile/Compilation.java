package arcomat.pipeline.compile;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What came of compiling Java.
 *
 * @param classes class files by internal name ({@code p/Robot}), those of files without errors
 * @param sources path of the source file by internal name of the class
 */
public record Compilation(
        Map<String, byte[]> classes, Map<String, String> sources, List<Problem> problems) {
    public Compilation {
        classes = Map.copyOf(classes);
        sources = Map.copyOf(sources);
        problems = List.copyOf(problems);
    }

    /**
     * An error of the compiler.
     *
     * @param path of the source file
     * @param start offset of the first character, or -1
     * @param end offset behind the last one
     * @param limit what there is too much of; empty where something else is wrong
     */
    public record Problem(
            String path, int line, int start, int end, String message, Optional<JavaLimit> limit) {
        /** The place in the source file. */
        public Span in(SourceFile file) {
            int length = file.text().length();
            int from = Math.min(Math.max(0, start), length);
            return file.span(from, Math.min(Math.max(from, end), length));
        }

        @Override
        public String toString() {
            return path + ":" + line + ": " + message;
        }
    }
}
