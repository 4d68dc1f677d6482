package arcomat.sim.load;

import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

import java.util.HashSet;
import java.util.Set;
import java.util.function.Predicate;

/** Sends calls in one method elsewhere. */
final class Redirection extends MethodVisitor {
    private static final String INSIDE = "arcomat/sim/inside/";
    private static final String SYSTEM = INSIDE + "BrickSystem";
    private static final String THREADS = INSIDE + "BrickThreads";
    private static final String MONITORS = INSIDE + "BrickMonitors";

    private static final Set<String> SYSTEM_MEMBERS =
            Set.of("currentTimeMillis", "nanoTime", "exit", "out", "err", "setOut", "setErr");
    private static final Set<String> RUNTIME_MEMBERS = Set.of("exit", "halt");
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

    private final Predicate<String> isThread;
    private final Set<Label> passed = new HashSet<>();

    Redirection(MethodVisitor next, Predicate<String> isThread) {
        super(Opcodes.ASM9, next);
        this.isThread = isThread;
    }

    @Override
    public void visitMethodInsn(
            int opcode, String owner, String name, String descriptor, boolean isInterface) {
        if (owner.equals("java/lang/System") && SYSTEM_MEMBERS.contains(name)) {
            callStatic(SYSTEM, name, descriptor);
        } else if (owner.equals("java/lang/Runtime") && RUNTIME_MEMBERS.contains(name)) {
            callStatic(SYSTEM, name, withReceiver(opcode, owner, descriptor));
        } else if (THREAD_MEMBERS.contains(name + descriptor) && isThread.test(owner)) {
            callStatic(THREADS, name, withReceiver(opcode, "java/lang/Thread", descriptor));
        } else if (MONITOR_MEMBERS.contains(name + descriptor)) {
            callStatic(MONITORS, name, withReceiver(opcode, "java/lang/Object", descriptor));
        } else if (owner.equals("java/util/Random") && (name + descriptor).equals("<init>()V")) {
            // A run must be the same every time: what the PC would seed from its clock starts at 0.
            super.visitInsn(Opcodes.LCONST_0);
            super.visitMethodInsn(opcode, owner, name, "(J)V", false);
        } else {
            super.visitMethodInsn(opcode, owner, name, descriptor, isInterface);
        }
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
        if (passed.contains(label)) {
            callStatic(SYSTEM, "loop", "()V");
        }
        super.visitJumpInsn(opcode, label);
    }
}
