package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;

import java.util.stream.Stream;

/** ARC0910: there is room for 1024 static fields in a program, leJOS' own included. */
final class StaticFieldLimit implements BrickLaw {
    private static final int FIELDS = 1024;

    @Override
    public String code() {
        return "ARC0910";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        int fields = (int) program.inClasses((file, node) -> variables(node)).count();
        return fields <= FIELDS
                ? Stream.empty()
                : Stream.of(
                        Diagnostic.error(
                                code(),
                                program.span(),
                                Limit.message(
                                        "the robot",
                                        fields,
                                        "static fields",
                                        FIELDS,
                                        "use fields of objects, or constants")));
    }

    /** Compilers copy constants to where they are read; nobody needs the fields any more. */
    private static Stream<FieldNode> variables(ClassNode node) {
        return node.fields.stream()
                .filter(f -> (f.access & Opcodes.ACC_STATIC) != 0 && f.value == null);
    }
}
