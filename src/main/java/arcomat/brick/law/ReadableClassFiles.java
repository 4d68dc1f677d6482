package arcomat.brick.law;

import arcomat.brick.jar.ClassFile;
import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import java.util.Optional;
import java.util.stream.Stream;

/** ARC0901: leJOS' linker reads class files of Java 5 to Java 17. */
final class ReadableClassFiles extends BrickLaw {
    private static final int OLDEST = 49;
    private static final int NEWEST = 61;

    /** Class files of Java n have version n + 44. */
    private static final int JAVA = 44;

    ReadableClassFiles() {
        super("ARC0901");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.files().stream()
                .flatMap(
                        file ->
                                problem(file)
                                        .map(text -> error(file.span(), "%s %s", file.name(), text))
                                        .stream());
    }

    private static Optional<String> problem(ClassFile file) {
        Optional<Integer> version = file.version();
        if (version.isPresent() && (version.get() < OLDEST || version.get() > NEWEST)) {
            return Optional.of(
                    "is a class file of version %d%s; the brick's linker reads 49 to 61: compile it for Java 6"
                            .formatted(
                                    version.get(),
                                    version.get() > NEWEST
                                            ? ", Java " + (version.get() - JAVA)
                                            : ""));
        }
        return file.node().isPresent()
                ? Optional.empty()
                : Optional.of("is not a class file, or a damaged one; make it anew");
    }
}
