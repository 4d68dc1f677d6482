package arcomat.brick;

import arcomat.source.Diagnostic;

import java.util.Optional;
import java.util.stream.Stream;

/** ARC0901: leJOS' linker reads class files of Java 5 to Java 17. */
final class ReadableClassFiles implements BrickLaw {
    private static final int OLDEST = 49;
    private static final int NEWEST = 61;

    /** Class files of Java n have version n + 44. */
    private static final int JAVA = 44;

    @Override
    public String code() {
        return "ARC0901";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.files().stream()
                .flatMap(
                        file ->
                                problem(file)
                                        .map(text -> Diagnostic.error(code(), file.span(), text))
                                        .stream());
    }

    private static Optional<String> problem(ClassFile file) {
        Optional<Integer> version = file.version();
        if (version.isPresent() && (version.get() < OLDEST || version.get() > NEWEST)) {
            return Optional.of(
                    file.name()
                            + " is a class file of version "
                            + version.get()
                            + (version.get() > NEWEST ? ", Java " + (version.get() - JAVA) : "")
                            + "; the brick's linker reads 49 to 61: compile it for Java 6");
        }
        return file.node().isPresent()
                ? Optional.empty()
                : Optional.of(file.name() + " is not a class file, or a damaged one; make it anew");
    }
}
