package arcomat.sim.load;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;

import java.util.ArrayDeque;
import java.util.HashSet;
import java.util.Set;

/**
 * The calls of constructors in a method.
 *
 * @param kept those after which the new object is on the stack
 * @param ofItself the call by which a constructor goes on to another one; null in other methods
 */
record Creations(Set<MethodInsnNode> kept, @Nullable MethodInsnNode ofItself) {
    static Creations of(MethodNode method) {
        Set<MethodInsnNode> kept = new HashSet<>();
        MethodInsnNode ofItself = null;
        ArrayDeque<TypeInsnNode> open = new ArrayDeque<>();
        for (AbstractInsnNode each : method.instructions) {
            if (each.getOpcode() == Opcodes.NEW) {
                open.push((TypeInsnNode) each);
            } else if (each instanceof MethodInsnNode call && call.name.equals("<init>")) {
                if (!open.isEmpty()) {
                    TypeInsnNode begun = open.pop();
                    if (isDoubled(begun) && begun.desc.equals(call.owner)) {
                        kept.add(call);
                    }
                } else if (ofItself == null) {
                    ofItself = call;
                }
            }
        }
        return new Creations(kept, ofItself);
    }

    /** As compilers write it where the object is used. */
    private static boolean isDoubled(TypeInsnNode begun) {
        AbstractInsnNode next = begun.getNext();
        while (next != null && next.getOpcode() < 0) {
            next = next.getNext();
        }
        return next != null && next.getOpcode() == Opcodes.DUP;
    }
}
