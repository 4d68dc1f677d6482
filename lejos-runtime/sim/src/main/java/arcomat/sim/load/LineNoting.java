package arcomat.sim.load;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.LineNumberNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.VarInsnNode;

import java.util.List;

/**
 * Has the objects of a class note lines, each in an array of its own. The class is one whose work
 * has been counted already.
 */
final class LineNoting {
    private static final String PROBES = "arcomat/sim/inside/BrickProbes";
    private static final String CONSTRUCTOR = "<init>";
    private static final String NOTES = "$notes";
    private static final String ARRAY = "[Z";

    private final ClassNode type;
    private final List<Integer> lines;

    private LineNoting(ClassNode type, List<Integer> lines) {
        this.type = type;
        this.lines = lines;
    }

    /** The class file with what is to be noted in the class. */
    static byte[] of(String name, byte[] classFile, List<NotedLines> all) {
        for (NotedLines each : all) {
            if (each.type().equals(name)) {
                ClassNode type = new ClassNode();
                new ClassReader(classFile).accept(type, 0);
                new LineNoting(type, each.lines()).put();
                ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
                type.accept(writer);
                return writer.toByteArray();
            }
        }
        return classFile;
    }

    private void put() {
        int hidden = Opcodes.ACC_PRIVATE | Opcodes.ACC_SYNTHETIC;
        type.fields.add(new FieldNode(hidden, NOTES, ARRAY, null, null));
        for (MethodNode method : type.methods) {
            if (method.name.equals(CONSTRUCTOR)) {
                AbstractInsnNode above = constructorAbove(method);
                if (above != null) {
                    note(above.getNext(), method);
                    method.instructions.insert(above, begin());
                }
            } else if ((method.access & Opcodes.ACC_STATIC) == 0) {
                note(method.instructions.getFirst(), method);
            }
        }
    }

    /** Before it, an object can do nothing. None where a constructor begins with another one. */
    private @Nullable AbstractInsnNode constructorAbove(MethodNode method) {
        for (AbstractInsnNode each : method.instructions) {
            if (each instanceof MethodInsnNode call
                    && call.getOpcode() == Opcodes.INVOKESPECIAL
                    && call.name.equals(CONSTRUCTOR)
                    && call.owner.equals(type.superName)) {
                return each;
            }
        }
        return null;
    }

    /** {@code $notes = BrickProbes.notes(this, SIZE);}. */
    private InsnList begin() {
        InsnList code = new InsnList();
        code.add(new VarInsnNode(Opcodes.ALOAD, 0));
        code.add(new VarInsnNode(Opcodes.ALOAD, 0));
        code.add(new LdcInsnNode(lines.size()));
        String descriptor = "(Ljava/lang/Object;I)" + ARRAY;
        code.add(new MethodInsnNode(Opcodes.INVOKESTATIC, PROBES, "notes", descriptor, false));
        code.add(new FieldInsnNode(Opcodes.PUTFIELD, type.name, NOTES, ARRAY));
        return code;
    }

    private void note(@Nullable AbstractInsnNode from, MethodNode method) {
        AbstractInsnNode each = from;
        while (each != null) {
            AbstractInsnNode next = each.getNext();
            if (each instanceof LineNumberNode line) {
                AbstractInsnNode first = firstInstruction(line);
                for (int number = 0; number < lines.size() && first != null; number++) {
                    if (lines.get(number) == line.line) {
                        put(note(number), first, method.instructions);
                    }
                }
            }
            each = next;
        }
    }

    /** What begins a line stands behind frames, which belong to where jumps lead. */
    private static @Nullable AbstractInsnNode firstInstruction(LineNumberNode line) {
        AbstractInsnNode next = line.getNext();
        while (next != null && next.getOpcode() < 0) {
            next = next.getNext();
        }
        return next;
    }

    /** Before an instruction; but frames name a NEW by its place, so nothing comes before that. */
    private static void put(InsnList note, AbstractInsnNode first, InsnList code) {
        if (first.getOpcode() == Opcodes.NEW) {
            code.insert(first, note);
        } else {
            code.insertBefore(first, note);
        }
    }

    /** {@code $notes[NUMBER] = true;}. */
    private InsnList note(int number) {
        InsnList code = new InsnList();
        code.add(new VarInsnNode(Opcodes.ALOAD, 0));
        code.add(new FieldInsnNode(Opcodes.GETFIELD, type.name, NOTES, ARRAY));
        code.add(new LdcInsnNode(number));
        code.add(new InsnNode(Opcodes.ICONST_1));
        code.add(new InsnNode(Opcodes.BASTORE));
        return code;
    }
}
