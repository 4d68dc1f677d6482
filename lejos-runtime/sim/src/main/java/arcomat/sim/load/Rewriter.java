package arcomat.sim.load;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

import java.util.Map;
import java.util.function.Predicate;

/**
 * Makes a class of a program run in virtual time: calls of the PC's clock, threads and locks go to
 * {@code arcomat.sim.inside}, and every loop takes time. Nothing else changes: what a jar does on a
 * simulated brick is what it says.
 */
final class Rewriter {
    private final Predicate<String> isThread;

    private Rewriter(Predicate<String> isThread) {
        this.isThread = isThread;
    }

    /** A rewriter for the classes of a program; it must know which of them are threads. */
    static Rewriter of(Map<String, byte[]> classes) {
        return new Rewriter(new ThreadClasses(classes)::contains);
    }

    byte[] rewrite(byte[] classFile) {
        ClassReader reader = new ClassReader(classFile);
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        reader.accept(new Methods(writer), 0);
        return writer.toByteArray();
    }

    private final class Methods extends ClassVisitor {
        private String owner;
        private boolean isInterface;

        Methods(ClassVisitor next) {
            super(Opcodes.ASM9, next);
        }

        @Override
        public void visit(
                int version,
                int access,
                String name,
                String signature,
                String superName,
                String[] interfaces) {
            owner = name;
            isInterface = (access & Opcodes.ACC_INTERFACE) != 0;
            super.visit(version, access, name, signature, superName, interfaces);
        }

        @Override
        public MethodVisitor visitMethod(
                int access, String name, String descriptor, String signature, String[] exceptions) {
            MethodVisitor visitor;
            if ((access & Opcodes.ACC_SYNCHRONIZED) != 0 && !isInterface) {
                visitor =
                        new SynchronizedMethod(owner, access, name, descriptor)
                                .split(cv, signature, exceptions);
            } else {
                visitor = super.visitMethod(access, name, descriptor, signature, exceptions);
            }
            return visitor == null ? null : new Redirection(visitor, isThread);
        }
    }
}
