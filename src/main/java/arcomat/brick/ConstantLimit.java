package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.LdcInsnNode;

import java.util.Arrays;
import java.util.stream.Stream;

/**
 * ARC0909: there is room for 1024 different constants in a program, leJOS' own included: texts and
 * the numbers that do not fit into an instruction.
 */
final class ConstantLimit implements BrickLaw {
    private static final int CONSTANTS = 1024;

    @Override
    public String code() {
        return "ARC0909";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        int constants = (int) program.inClasses((file, node) -> constants(node)).distinct().count();
        return constants <= CONSTANTS
                ? Stream.empty()
                : Stream.of(
                        Diagnostic.error(
                                code(),
                                program.span(),
                                Limit.message(
                                        "the robot",
                                        constants,
                                        "different constants",
                                        CONSTANTS,
                                        "use fewer texts and large numbers")));
    }

    private static Stream<Object> constants(ClassNode node) {
        return node.methods.stream()
                .flatMap(method -> Arrays.stream(method.instructions.toArray()))
                .filter(LdcInsnNode.class::isInstance)
                .map(instruction -> ((LdcInsnNode) instruction).cst);
    }
}
