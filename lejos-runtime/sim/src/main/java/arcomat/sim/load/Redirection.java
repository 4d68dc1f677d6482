package arcomat.sim.load;

import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

import java.util.HashSet;
import java.util.Set;

/** Sends calls in one method elsewhere. */
final class Redirection extends MethodVisitor {
    private static final String INSIDE = "arcomat/sim/inside/";
    private static final String SYSTEM = INSIDE + "BrickSystem";
    private static final String THREADS = INSIDE + "BrickThreads";
    private static final String MONITORS = INSIDE + "BrickMonitors";
    private static final String ERRORS = INSIDE + "BrickErrors";

    private static final Set<String> SYSTEM_MEMBERS =
            Set.of("currentTimeMillis", "nanoTime", "exit", "gc", "out", "err", "setOut", "setErr");
    private static final Set<String> RUNTIME_MEMBERS = Set.of("exit", "gc", "halt");
    private static final Set<String> THREAD_MEMBERS =
            Set.of(
                    "start()V",
                    "join()V",
                    "join(J)V",
                    "isAlive()Z",
                    "setDaemon(Z)V",
                    "isDaemon()Z",
                    "interrupt()V",
                    "isInterrupted()Z",
                    "interrupted()Z",
                    "currentThread()Ljava/lang/Thread;",
                    "sleep(J)V",
                    "yield()V");
    private static final Set<String> MONITOR_MEMBERS =
            Set.of("wait()V", "wait(J)V", "wait(JI)V", "notify()V", "notifyAll()V");

    private static final Set<String> ERROR_MEMBERS =
            Set.of(
                    "getMessage()Ljava/lang/String;",
                    "getLocalizedMessage()Ljava/lang/String;",
                    "toString()Ljava/lang/String;",
                    "printStackTrace()V",
                    "printStackTrace(Ljava/io/PrintStream;)V");

    /** Methods that make a text of the object on the stack. */
    private static final Set<String> SHOWING =
            Set.of(
                    "java/lang/StringBuilder.append",
                    "java/lang/StringBuffer.append",
                    "java/lang/String.valueOf",
                    "java/io/PrintStream.print",
                    "java/io/PrintStream.println");

    private final Superclasses superclasses;
    private final boolean counted;
    private final Set<Label> passed = new HashSet<>();

    /**
     * @param counted whether the program has the brick's speed, so that loops take time anyway, and
     *     the brick's errors
     */
    Redirection(MethodVisitor next, Superclasses superclasses, boolean counted) {
        super(Opcodes.ASM9, next);
        this.superclasses = superclasses;
        this.counted = counted;
    }

    @Override
    public void visitMethodInsn(
            int opcode, String owner, String name, String descriptor, boolean isInterface) {
        if (owner.equals("java/lang/System") && SYSTEM_MEMBERS.contains(name)) {
            callStatic(SYSTEM, name, descriptor);
        } else if (owner.equals("java/lang/Runtime") && RUNTIME_MEMBERS.contains(name)) {
            callStatic(SYSTEM, name, withReceiver(opcode, owner, descriptor));
        } else if (THREAD_MEMBERS.contains(name + descriptor) && superclasses.isThread(owner)) {
            callStatic(THREADS, name, withReceiver(opcode, "java/lang/Thread", descriptor));
        } else if (MONITOR_MEMBERS.contains(name + descriptor)) {
            callStatic(MONITORS, name, withReceiver(opcode, "java/lang/Object", descriptor));
        } else if (owner.equals("java/util/Random") && (name + descriptor).equals("<init>()V")) {
            // A run must be the same every time: what the PC would seed from its clock starts at 0.
            super.visitInsn(Opcodes.LCONST_0);
            super.visitMethodInsn(opcode, owner, name, "(J)V", false);
        } else if (counted && isOfError(opcode, owner, name + descriptor)) {
            callStatic(ERRORS, name, withReceiver(opcode, "java/lang/Throwable", descriptor));
        } else {
            if (counted
                    && descriptor.startsWith("(Ljava/lang/Object;)")
                    && SHOWING.contains(owner + "." + name)) {
                callStatic(ERRORS, "shown", "(Ljava/lang/Object;)Ljava/lang/Object;");
            }
            super.visitMethodInsn(opcode, owner, name, descriptor, isInterface);
        }
    }

    private boolean isOfError(int opcode, String owner, String member) {
        return opcode == Opcodes.INVOKEVIRTUAL
                && ERROR_MEMBERS.contains(member)
                && superclasses.isError(owner);
    }

    /** A timer of the PC would run by the PC's clock. */
    @Override
    public void visitTypeInsn(int opcode, String type) {
        if (opcode == Opcodes.NEW && type.equals("java/util/Timer")) {
            throw new UnsupportedOperationException(
                    "java.util.Timer is not simulated: let a thread sleep instead");
        }
        super.visitTypeInsn(opcode, type);
    }

    private void callStatic(String owner, String name, String descriptor) {
        super.visitMethodInsn(Opcodes.INVOKESTATIC, owner, name, descriptor, false);
    }

    /** A method becomes a static one with its object as the first parameter. */
    private static String withReceiver(int opcode, String type, String descriptor) {
        return opcode == Opcodes.INVOKESTATIC
                ? descriptor
                : "(L" + type + ";" + descriptor.substring(1);
    }

    @Override
    public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
        boolean system = owner.equals("java/lang/System") && SYSTEM_MEMBERS.contains(name);
        super.visitFieldInsn(opcode, system ? SYSTEM : owner, name, descriptor);
    }

    @Override
    public void visitInsn(int opcode) {
        if (opcode == Opcodes.MONITORENTER) {
            callStatic(MONITORS, "enter", "(Ljava/lang/Object;)V");
        } else if (opcode == Opcodes.MONITOREXIT) {
            callStatic(MONITORS, "exit", "(Ljava/lang/Object;)V");
        } else {
            super.visitInsn(opcode);
        }
    }

    @Override
    public void visitLabel(Label label) {
        passed.add(label);
        super.visitLabel(label);
    }

    @Override
    public void visitJumpInsn(int opcode, Label label) {
        if (!counted && passed.contains(label)) {
            callStatic(SYSTEM, "loop", "()V");
        }
        super.visitJumpInsn(opcode, label);
    }
}
