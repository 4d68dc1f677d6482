package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.MethodNode;

import java.util.stream.Stream;

/**
 * ARC0908: calls on the brick carry at most 16 words, of which the object called upon is one and
 * each long or double two.
 */
final class ParameterLimit extends Limit {
    ParameterLimit() {
        super("ARC0908", "parameter words", 16, "pass an object or use fields");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.inClasses(
                (file, node) ->
                        node.methods.stream()
                                .filter(m -> isExceededBy(words(m)))
                                .map(m -> excess(file.span(m), file.where(m), words(m))));
    }

    private static int words(MethodNode method) {
        boolean isStatic = (method.access & Opcodes.ACC_STATIC) != 0;
        int withReceiver = Type.getArgumentsAndReturnSizes(method.desc) >> 2;
        return isStatic ? withReceiver - 1 : withReceiver;
    }
}
