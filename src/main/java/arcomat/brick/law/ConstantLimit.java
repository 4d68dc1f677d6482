package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.LdcInsnNode;

import java.util.Arrays;
import java.util.stream.Stream;

/**
 * ARC0909: there is room for 1024 different constants in a program, leJOS' own included: texts and
 * the numbers that do not fit into an instruction.
 */
final class ConstantLimit extends Limit {
    ConstantLimit() {
        super("ARC0909", "different constants", 1024, "use fewer texts and large numbers");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        int constants = (int) program.inClasses((file, node) -> constants(node)).distinct().count();
        return Stream.of(constants)
                .filter(this::isExceededBy)
                .map(number -> excess(program.span(), "the robot", number));
    }

    private static Stream<Object> constants(ClassNode node) {
        return node.methods.stream()
                .flatMap(method -> Arrays.stream(method.instructions.toArray()))
                .filter(LdcInsnNode.class::isInstance)
                .map(instruction -> ((LdcInsnNode) instruction).cst);
    }
}
