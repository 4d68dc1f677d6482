package arcomat.brick.need.flow;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.IntInsnNode;
import org.objectweb.asm.tree.LdcInsnNode;

import java.util.OptionalInt;

/** Whole numbers that instructions push. */
public final class Constants {
    private Constants() {}

    /** The number that an instruction pushes, if it always pushes the same one. */
    public static OptionalInt pushed(AbstractInsnNode instruction) {
        int opcode = instruction == null ? -1 : instruction.getOpcode();
        if (instruction instanceof InsnNode
                && opcode >= Opcodes.ICONST_M1
                && opcode <= Opcodes.ICONST_5) {
            return OptionalInt.of(opcode - Opcodes.ICONST_0);
        }
        if (instruction instanceof IntInsnNode number && opcode != Opcodes.NEWARRAY) {
            return OptionalInt.of(number.operand);
        }
        if (instruction instanceof LdcInsnNode number && number.cst instanceof Integer value) {
            return OptionalInt.of(value);
        }
        return OptionalInt.empty();
    }

    /** The instruction before one, labels and lines left out; null at the start. */
    public static AbstractInsnNode before(AbstractInsnNode instruction) {
        AbstractInsnNode each = instruction.getPrevious();
        while (each != null && each.getOpcode() < 0) {
            each = each.getPrevious();
        }
        return each;
    }
}
