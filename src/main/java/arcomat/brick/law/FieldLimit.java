package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;

import java.util.stream.Stream;

/** ARC0906: the brick numbers the fields of an object that a class declares with one byte. */
final class FieldLimit extends Limit {
    FieldLimit() {
        super("ARC0906", "fields", 255, "divide it into several classes");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.inClasses(
                (file, node) ->
                        Stream.of(fields(node))
                                .filter(this::isExceededBy)
                                .map(number -> excess(file.span(), file.name(), number)));
    }

    private static int fields(ClassNode node) {
        return (int) node.fields.stream().filter(f -> (f.access & Opcodes.ACC_STATIC) == 0).count();
    }
}
