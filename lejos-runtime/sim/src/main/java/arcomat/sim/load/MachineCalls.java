package arcomat.sim.load;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;

/** Code that calls the simulated machine. */
final class MachineCalls {
    private static final String MACHINE = "arcomat/sim/inside/BrickMachine";
    private static final String ERRORS = "arcomat/sim/inside/BrickErrors";
    private static final String OF_CLASS = "(Ljava/lang/Class;)V";
    private static final String OF_OBJECT = "(Ljava/lang/Object;)V";

    private MachineCalls() {}

    static InsnList enter(int variables, int frame, int work) {
        InsnList code = new InsnList();
        code.add(new LdcInsnNode(variables));
        code.add(new LdcInsnNode(frame));
        code.add(new LdcInsnNode(work));
        code.add(to("enter", "(III)I"));
        return code;
    }

    static InsnList leave() {
        return only(to("leave", "()V"));
    }

    static InsnList work(int microseconds) {
        return number("work", microseconds);
    }

    static InsnList count(int microseconds) {
        return number("count", microseconds);
    }

    static InsnList grown(int bytes) {
        return number("grown", bytes);
    }

    private static InsnList number(String name, int number) {
        InsnList code = new InsnList();
        code.add(new LdcInsnNode(number));
        code.add(to(name, "(I)V"));
        return code;
    }

    /** The depth is on the stack. */
    static InsnList caught(int variables) {
        InsnList code = new InsnList();
        code.add(new LdcInsnNode(variables));
        code.add(to("caught", "(II)V"));
        return code;
    }

    /** The object is on the stack. */
    static InsnList hold(int variable) {
        InsnList code = new InsnList();
        code.add(new LdcInsnNode(variable));
        code.add(to("hold", "(Ljava/lang/Object;I)V"));
        return code;
    }

    static InsnList call(String name, Type type) {
        InsnList code = new InsnList();
        code.add(new LdcInsnNode(type));
        code.add(to(name, OF_CLASS));
        return code;
    }

    /** The length is on the stack, and stays. */
    static InsnList makeArray(int element) {
        InsnList code = new InsnList();
        code.add(
                new FieldInsnNode(
                        Opcodes.GETSTATIC,
                        "java/lang/" + box(element),
                        "TYPE",
                        "Ljava/lang/Class;"));
        code.add(to("makeArray", "(ILjava/lang/Class;)I"));
        return code;
    }

    static InsnList makeArrayOfObjects() {
        InsnList code = new InsnList();
        code.add(new LdcInsnNode(Type.getType(Object.class)));
        code.add(to("makeArray", "(ILjava/lang/Class;)I"));
        return code;
    }

    private static String box(int element) {
        return switch (element) {
            case Opcodes.T_BOOLEAN -> "Boolean";
            case Opcodes.T_CHAR -> "Character";
            case Opcodes.T_FLOAT -> "Float";
            case Opcodes.T_DOUBLE -> "Double";
            case Opcodes.T_BYTE -> "Byte";
            case Opcodes.T_SHORT -> "Short";
            case Opcodes.T_INT -> "Integer";
            default -> "Long";
        };
    }

    /** The object is on the stack, and stays; so in what follows. */
    static InsnList given() {
        return shown(to("given", OF_OBJECT));
    }

    static InsnList made() {
        return shown(
                new MethodInsnNode(
                        Opcodes.INVOKESTATIC, ERRORS, "made", "(Ljava/lang/Throwable;)V", false));
    }

    static InsnList await() {
        return shown(to("await", OF_OBJECT));
    }

    static InsnList awaited() {
        return only(to("awaited", "()V"));
    }

    private static InsnList shown(MethodInsnNode call) {
        InsnList code = new InsnList();
        code.add(new InsnNode(Opcodes.DUP));
        code.add(call);
        return code;
    }

    private static InsnList only(MethodInsnNode call) {
        InsnList code = new InsnList();
        code.add(call);
        return code;
    }

    private static MethodInsnNode to(String name, String descriptor) {
        return new MethodInsnNode(Opcodes.INVOKESTATIC, MACHINE, name, descriptor, false);
    }
}
