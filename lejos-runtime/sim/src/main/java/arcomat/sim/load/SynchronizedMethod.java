package arcomat.sim.load;

import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

import java.util.ArrayList;
import java.util.List;

/**
 * Splits a synchronized method: its body goes to a method of its own, and in its place stands one
 * that takes the lock, calls the body and gives the lock back in every case.
 */
final class SynchronizedMethod {
    private static final String MONITORS = "arcomat/sim/inside/BrickMonitors";
    private static final String BODY = "$locked";

    private final String owner;
    private final int access;
    private final String name;
    private final String descriptor;
    private final boolean isStatic;

    SynchronizedMethod(String owner, int access, String name, String descriptor) {
        this.owner = owner;
        this.access = access & ~Opcodes.ACC_SYNCHRONIZED;
        this.name = name;
        this.descriptor = descriptor;
        this.isStatic = (access & Opcodes.ACC_STATIC) != 0;
    }

    /** Writes the outer method; the visitor returned takes the body. */
    MethodVisitor split(ClassVisitor target, String signature, String[] exceptions) {
        writeOuter(target.visitMethod(access, name, descriptor, signature, exceptions));
        int hidden = isStatic ? Opcodes.ACC_STATIC : 0;
        return target.visitMethod(
                Opcodes.ACC_PRIVATE | Opcodes.ACC_SYNTHETIC | hidden,
                name + BODY,
                descriptor,
                null,
                exceptions);
    }

    private void writeOuter(MethodVisitor code) {
        Label start = new Label();
        Label end = new Label();
        Label handler = new Label();
        code.visitCode();
        code.visitTryCatchBlock(start, end, handler, null);
        lock(code, "enter");
        code.visitLabel(start);
        callBody(code);
        code.visitLabel(end);
        lock(code, "exit");
        code.visitInsn(Type.getReturnType(descriptor).getOpcode(Opcodes.IRETURN));
        code.visitLabel(handler);
        visitHandlerFrame(code);
        lock(code, "exit");
        code.visitInsn(Opcodes.ATHROW);
        code.visitMaxs(0, 0);
        code.visitEnd();
    }

    private void lock(MethodVisitor code, String operation) {
        if (isStatic) {
            code.visitLdcInsn(Type.getObjectType(owner));
        } else {
            code.visitVarInsn(Opcodes.ALOAD, 0);
        }
        code.visitMethodInsn(
                Opcodes.INVOKESTATIC, MONITORS, operation, "(Ljava/lang/Object;)V", false);
    }

    private void callBody(MethodVisitor code) {
        int local = 0;
        if (!isStatic) {
            code.visitVarInsn(Opcodes.ALOAD, local++);
        }
        for (Type parameter : Type.getArgumentTypes(descriptor)) {
            code.visitVarInsn(parameter.getOpcode(Opcodes.ILOAD), local);
            local += parameter.getSize();
        }
        int call = isStatic ? Opcodes.INVOKESTATIC : Opcodes.INVOKESPECIAL;
        code.visitMethodInsn(call, owner, name + BODY, descriptor, false);
    }

    /** In the handler the locals are the parameters, and the error is all there is on the stack. */
    private void visitHandlerFrame(MethodVisitor code) {
        List<Object> locals = new ArrayList<>();
        if (!isStatic) {
            locals.add(owner);
        }
        for (Type parameter : Type.getArgumentTypes(descriptor)) {
            locals.add(verificationType(parameter));
        }
        Object[] stack = {"java/lang/Throwable"};
        code.visitFrame(Opcodes.F_FULL, locals.size(), locals.toArray(), 1, stack);
    }

    private static Object verificationType(Type type) {
        return switch (type.getSort()) {
            case Type.LONG -> Opcodes.LONG;
            case Type.DOUBLE -> Opcodes.DOUBLE;
            case Type.FLOAT -> Opcodes.FLOAT;
            case Type.ARRAY, Type.OBJECT -> type.getInternalName();
            default -> Opcodes.INTEGER;
        };
    }
}
