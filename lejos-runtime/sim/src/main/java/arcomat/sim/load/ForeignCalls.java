package arcomat.sim.load;

import org.objectweb.asm.Type;
import org.objectweb.asm.tree.MethodInsnNode;

import java.util.Set;

/** What calls of code that is not the program's own do to its memory and to its slices. */
final class ForeignCalls {
    private static final Set<String> GROWING =
            Set.of(
                    "add",
                    "addAll",
                    "addElement",
                    "addFirst",
                    "addLast",
                    "append",
                    "insert",
                    "insertElementAt",
                    "offer",
                    "push",
                    "put",
                    "putAll");

    private static final Set<String> BOXES =
            Set.of(
                    "java/lang/Boolean",
                    "java/lang/Byte",
                    "java/lang/Character",
                    "java/lang/Double",
                    "java/lang/Float",
                    "java/lang/Integer",
                    "java/lang/Long",
                    "java/lang/Short");

    /** The clock of generated programs; a slice is what they do between two waits for it. */
    private static final String CLOCK = "arcomat/rt/Cycle";

    /** Bytes by which a collection may grow with a call. */
    private static final int ENTRY = 24;

    /** Bytes by which a text may grow with a call. */
    private static final int TEXT = 64;

    private ForeignCalls() {}

    static boolean isJavas(MethodInsnNode call) {
        return call.owner.startsWith("java/");
    }

    static boolean isError(String type) {
        return type.startsWith("java/")
                && (type.endsWith("Exception")
                        || type.endsWith("Error")
                        || type.endsWith("/Throwable"));
    }

    /** Whether what it returns may be a new object. */
    static boolean givesObject(MethodInsnNode call) {
        if (!isJavas(call) && !BrickLoader.isOfTheBrick(call.owner.replace('/', '.'))) {
            return false;
        }
        Type type = Type.getReturnType(call.desc);
        return type.getSort() == Type.ARRAY
                || type.getSort() == Type.OBJECT
                        && (type.getInternalName().equals("java/lang/String")
                                || BOXES.contains(type.getInternalName()));
    }

    static boolean grows(MethodInsnNode call) {
        return isJavas(call) && GROWING.contains(call.name);
    }

    static int growth(MethodInsnNode call) {
        return call.owner.startsWith("java/util/") ? ENTRY : TEXT;
    }

    static boolean waitsForSlice(MethodInsnNode call) {
        return call.owner.equals(CLOCK) && call.name.equals("await") && call.desc.equals("()Z");
    }
}
