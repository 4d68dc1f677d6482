package arcomat.brick.need;

import arcomat.brick.api.BrickCost;

import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;

/** How long methods take at most, in microseconds. */
final class Times extends MethodWeights {
    Times(Code code, Library library) {
        super(code, library);
    }

    @Override
    protected boolean isLookedInto(MethodName method) {
        return library.measured(method).isEmpty();
    }

    @Override
    protected long own(AbstractInsnNode instruction) {
        if (instruction.getOpcode() < 0) {
            return 0; // a label or a line
        }
        return instruction instanceof MethodInsnNode
                ? BrickCost.MICROSECONDS_PER_CALL
                : BrickCost.MICROSECONDS_PER_BYTECODE;
    }

    @Override
    protected long ofLibrary(MethodName method) {
        return library.time(method);
    }
}
