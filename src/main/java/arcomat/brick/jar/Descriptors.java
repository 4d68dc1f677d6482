package arcomat.brick.jar;

import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.InvokeDynamicInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.MultiANewArrayInsnNode;
import org.objectweb.asm.tree.TypeInsnNode;

import java.util.Arrays;
import java.util.regex.Pattern;

/** Whether the types in a class file are written as they have to be; ASM reads them unseen. */
final class Descriptors {
    private static final String TYPE = "\\[*+(?:[BCDFIJSZ]|L[^;\\[]++;)";
    private static final Pattern FIELD = Pattern.compile(TYPE);
    private static final Pattern METHOD =
            Pattern.compile("\\((?:" + TYPE + ")*+\\)(?:V|" + TYPE + ")");

    private Descriptors() {}

    static boolean areWellFormed(ClassNode node) {
        return node.fields.stream().allMatch(field -> isField(field.desc))
                && node.methods.stream().allMatch(Descriptors::areWellFormed);
    }

    private static boolean areWellFormed(MethodNode method) {
        return isMethod(method.desc)
                && Arrays.stream(method.instructions.toArray()).allMatch(Descriptors::isWellFormed);
    }

    private static boolean isWellFormed(AbstractInsnNode instruction) {
        if (instruction instanceof FieldInsnNode i) {
            return isField(i.desc) && isOwner(i.owner);
        }
        if (instruction instanceof MethodInsnNode i) {
            return isMethod(i.desc) && isOwner(i.owner);
        }
        if (instruction instanceof InvokeDynamicInsnNode i) {
            return isMethod(i.desc);
        }
        if (instruction instanceof MultiANewArrayInsnNode i) {
            return isField(i.desc);
        }
        return !(instruction instanceof TypeInsnNode i) || isOwner(i.desc);
    }

    private static boolean isField(String descriptor) {
        return FIELD.matcher(descriptor).matches();
    }

    private static boolean isMethod(String descriptor) {
        return METHOD.matcher(descriptor).matches();
    }

    /** A class by its name, an array by its descriptor. */
    private static boolean isOwner(String name) {
        return !name.isEmpty() && (!name.startsWith("[") || isField(name));
    }
}
