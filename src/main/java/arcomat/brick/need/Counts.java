package arcomat.brick.need;

import arcomat.brick.need.flow.MethodName;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.TypeInsnNode;

/** How many objects of a class methods make at most. */
final class Counts extends MethodWeights {
    private final String type;

    Counts(Code code, LibraryCost library, String type) {
        super(code, library);
        this.type = type;
    }

    @Override
    protected long own(AbstractInsnNode instruction) {
        return instruction instanceof TypeInsnNode made
                        && made.getOpcode() == Opcodes.NEW
                        && made.desc.equals(type)
                ? 1
                : 0;
    }

    @Override
    protected long ofLibrary(MethodName method) {
        return 0;
    }
}
