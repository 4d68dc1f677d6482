package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;

import java.util.stream.Stream;

/** ARC0910: there is room for 1024 static fields in a program, leJOS' own included. */
final class StaticFieldLimit extends Limit {
    StaticFieldLimit() {
        super("ARC0910", "static fields", 1024, "use fields of objects, or constants");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        int fields = (int) program.inClasses((file, node) -> variables(node)).count();
        return Stream.of(fields)
                .filter(this::isExceededBy)
                .map(number -> excess(program.span(), "the robot", number));
    }

    /** Compilers copy constants to where they are read; nobody needs the fields any more. */
    private static Stream<FieldNode> variables(ClassNode node) {
        return node.fields.stream()
                .filter(f -> (f.access & Opcodes.ACC_STATIC) != 0 && f.value == null);
    }
}
