package arcomat.sim.load;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.analysis.AnalyzerException;
import org.objectweb.asm.tree.analysis.BasicInterpreter;
import org.objectweb.asm.tree.analysis.BasicValue;

/**
 * Types of variables as Java's verifier sees them, where that can be told without other classes.
 */
final class ExactTypes extends BasicInterpreter {
    /** An object of a type that cannot be told. */
    static final BasicValue UNKNOWN = new BasicValue(Type.getObjectType("?"));

    ExactTypes() {
        super(Opcodes.ASM9);
    }

    static boolean isNull(BasicValue value) {
        return value.isReference() && value.getType().equals(NULL_TYPE);
    }

    @Override
    public BasicValue newValue(Type type) {
        return type != null && Variables.isObject(type)
                ? new BasicValue(type)
                : super.newValue(type);
    }

    @Override
    public BasicValue binaryOperation(
            AbstractInsnNode instruction, BasicValue first, BasicValue second)
            throws AnalyzerException {
        return instruction.getOpcode() == Opcodes.AALOAD
                ? UNKNOWN
                : super.binaryOperation(instruction, first, second);
    }

    @Override
    public BasicValue merge(BasicValue first, BasicValue second) {
        if (first.equals(second) || isNull(second) && first.isReference()) {
            return first;
        }
        if (isNull(first) && second.isReference()) {
            return second;
        }
        return first.isReference() && second.isReference()
                ? UNKNOWN
                : BasicValue.UNINITIALIZED_VALUE;
    }
}
