package arcomat.sim.load;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

import java.util.List;

/** Puts probes into a class of a program whose work has been counted already. */
final class Probing extends ClassVisitor {
    private static final String PROBES = "arcomat/sim/inside/BrickProbes";

    private final List<String> methods;

    private Probing(ClassVisitor next, List<String> methods) {
        super(Opcodes.ASM9, next);
        this.methods = methods;
    }

    /** The class file with the probes that are meant for the class. */
    static byte[] of(String name, byte[] classFile, List<Probe> probes) {
        List<String> methods =
                probes.stream()
                        .filter(each -> each.type().equals(name))
                        .map(Probe::method)
                        .toList();
        if (methods.isEmpty()) {
            return classFile;
        }
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        new ClassReader(classFile).accept(new Probing(writer, methods), 0);
        return writer.toByteArray();
    }

    @Override
    public @Nullable MethodVisitor visitMethod(
            int access, String name, String descriptor, String signature, String[] exceptions) {
        MethodVisitor next = super.visitMethod(access, name, descriptor, signature, exceptions);
        boolean isStatic = (access & Opcodes.ACC_STATIC) != 0;
        if (next == null || isStatic || !methods.contains(name)) {
            return next;
        }
        return new MethodVisitor(Opcodes.ASM9, next) {
            @Override
            public void visitCode() {
                super.visitCode();
                tell("entered");
            }

            @Override
            public void visitInsn(int opcode) {
                if (Opcodes.IRETURN <= opcode && opcode <= Opcodes.RETURN) {
                    tell("left");
                }
                super.visitInsn(opcode);
            }

            private void tell(String what) {
                super.visitVarInsn(Opcodes.ALOAD, 0);
                super.visitLdcInsn(name);
                super.visitMethodInsn(
                        Opcodes.INVOKESTATIC,
                        PROBES,
                        what,
                        "(Ljava/lang/Object;Ljava/lang/String;)V",
                        false);
            }
        };
    }
}
