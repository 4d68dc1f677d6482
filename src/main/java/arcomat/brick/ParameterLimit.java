package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.MethodNode;

import java.util.stream.Stream;

/**
 * ARC0908: calls on the brick carry at most 16 words, of which the object called upon is one and
 * each long or double two.
 */
final class ParameterLimit implements BrickLaw {
    private static final int WORDS = 16;

    @Override
    public String code() {
        return "ARC0908";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.inClasses(
                (file, node) ->
                        node.methods.stream()
                                .filter(method -> words(method) > WORDS)
                                .map(method -> finding(file, method)));
    }

    private static int words(MethodNode method) {
        boolean isStatic = (method.access & Opcodes.ACC_STATIC) != 0;
        int withReceiver = Type.getArgumentsAndReturnSizes(method.desc) >> 2;
        return isStatic ? withReceiver - 1 : withReceiver;
    }

    private Diagnostic finding(ClassFile file, MethodNode method) {
        return Diagnostic.error(
                code(),
                file.span(method),
                Limit.message(
                        file.where(method),
                        words(method),
                        "parameter words",
                        WORDS,
                        "pass an object or use fields"));
    }
}
