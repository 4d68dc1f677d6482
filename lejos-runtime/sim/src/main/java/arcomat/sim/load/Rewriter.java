package arcomat.sim.load;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;

import java.util.Map;

/**
 * Makes a class of a program run in virtual time: calls of the PC's clock, threads and locks go to
 * {@code arcomat.sim.inside}, and every loop takes time, if nothing else does. Nothing else
 * changes: what a jar does on a simulated brick is what it says.
 */
final class Rewriter {
    private final Superclasses superclasses;
    private final boolean counted;

    private Rewriter(Superclasses superclasses, boolean counted) {
        this.superclasses = superclasses;
        this.counted = counted;
    }

    /**
     * A rewriter for the classes of a program; it must know which of them are threads, and which
     * are errors.
     *
     * @param counted whether the program has the brick's memory, its calls and its speed
     */
    static Rewriter of(Map<String, byte[]> classes, boolean counted) {
        return new Rewriter(new Superclasses(classes), counted);
    }

    byte[] rewrite(byte[] classFile) {
        ClassReader reader = new ClassReader(classFile);
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        if (counted) {
            ClassNode type = new ClassNode();
            reader.accept(type, ClassReader.EXPAND_FRAMES);
            Metering.meter(type);
            type.accept(new Methods(writer));
        } else {
            reader.accept(new Methods(writer), 0);
        }
        return writer.toByteArray();
    }

    private final class Methods extends ClassVisitor {
        private String owner = "";
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
        public @Nullable MethodVisitor visitMethod(
                int access, String name, String descriptor, String signature, String[] exceptions) {
            MethodVisitor visitor;
            if ((access & Opcodes.ACC_SYNCHRONIZED) != 0 && !isInterface) {
                visitor =
                        new SynchronizedMethod(owner, access, name, descriptor)
                                .split(cv, signature, exceptions);
            } else {
                visitor = super.visitMethod(access, name, descriptor, signature, exceptions);
            }
            return visitor == null ? null : new Redirection(visitor, superclasses, counted);
        }
    }
}
