package arcomat.brick.api;

import org.objectweb.asm.AnnotationVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

import java.util.Set;

/**
 * Writes stub classes: what a compiler must know of a class to compile against it, and bodies that
 * throw. Class files are of version 49, the first with generic signatures and annotations.
 */
public final class StubWriter {
    private static final String THROWN = "java/lang/UnsupportedOperationException";
    private static final String RETENTION = "java/lang/annotation/Retention";

    /**
     * Annotations that the language wants gone after compilation (JLS 9.6.1). The table does not
     * say so, and a compiler would copy them into every class file.
     */
    private static final Set<String> SOURCE_ONLY =
            Set.of("java/lang/Override", "java/lang/SuppressWarnings");

    private final BrickTable table;

    public StubWriter(BrickTable table) {
        this.table = table;
    }

    /** The stub of a class of the table as a class file. The same table gives the same bytes. */
    public byte[] write(BrickType type) {
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        writer.visit(
                Opcodes.V1_5,
                type.access() | (type.isInterface() ? 0 : Opcodes.ACC_SUPER),
                type.name(),
                type.signature().orElse(null),
                type.superclass().orElse(null),
                type.interfaces().toArray(new String[0]));
        if (SOURCE_ONLY.contains(type.name())) {
            keepInSourceOnly(writer);
        }
        writeSurroundings(writer, type);
        table.nestedIn(type.name()).forEach(inner -> writeNesting(writer, inner));
        type.fields().forEach(field -> writeField(writer, field));
        type.methods().forEach(method -> writeMethod(writer, type, method));
        writer.visitEnd();
        return writer.toByteArray();
    }

    private static void keepInSourceOnly(ClassWriter writer) {
        AnnotationVisitor retention = writer.visitAnnotation("L" + RETENTION + ";", true);
        retention.visitEnum("value", "L" + RETENTION + "Policy;", "SOURCE");
        retention.visitEnd();
    }

    /** Outermost first: a nested class names itself and all classes around it. */
    private void writeSurroundings(ClassWriter writer, BrickType type) {
        type.nesting()
                .flatMap(nesting -> table.type(nesting.outer()))
                .ifPresent(outer -> writeSurroundings(writer, outer));
        writeNesting(writer, type);
    }

    private static void writeNesting(ClassWriter writer, BrickType type) {
        type.nesting()
                .ifPresent(
                        n ->
                                writer.visitInnerClass(
                                        type.name(), n.outer(), n.simpleName(), n.access()));
    }

    private static void writeField(ClassWriter writer, BrickField field) {
        FieldVisitor visitor =
                writer.visitField(
                        field.access(),
                        field.name(),
                        field.descriptor(),
                        field.signature().orElse(null),
                        field.constant().orElse(null));
        visitor.visitEnd();
    }

    private static void writeMethod(ClassWriter writer, BrickType type, BrickMethod method) {
        MethodVisitor visitor =
                writer.visitMethod(
                        method.access(),
                        method.name(),
                        method.descriptor(),
                        method.signature().orElse(null),
                        method.exceptions().toArray(new String[0]));
        if ((method.access() & Opcodes.ACC_ABSTRACT) == 0) {
            writeBody(visitor, type.name().replace('/', '.') + "." + method.name());
        }
        visitor.visitEnd();
    }

    private static void writeBody(MethodVisitor visitor, String name) {
        visitor.visitCode();
        visitor.visitTypeInsn(Opcodes.NEW, THROWN);
        visitor.visitInsn(Opcodes.DUP);
        visitor.visitLdcInsn(name + " runs on the brick only");
        visitor.visitMethodInsn(
                Opcodes.INVOKESPECIAL, THROWN, "<init>", "(Ljava/lang/String;)V", false);
        visitor.visitInsn(Opcodes.ATHROW);
        visitor.visitMaxs(0, 0);
    }
}
