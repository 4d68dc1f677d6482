package arcomat.sim.load;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.LineNumberNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Puts probes at lines into a class of a program whose work has been counted already. */
final class LineProbing {
    private static final String PROBES = "arcomat/sim/inside/BrickProbes";

    private LineProbing() {}

    /** The class file with the probes that are meant for the class. */
    static byte[] of(String name, byte[] classFile, List<LineProbe> probes) {
        Map<Integer, Integer> numbers = new HashMap<>();
        probes.stream()
                .filter(each -> each.type().equals(name))
                .forEach(each -> numbers.put(each.line(), each.number()));
        if (numbers.isEmpty()) {
            return classFile;
        }
        ClassNode type = new ClassNode();
        new ClassReader(classFile).accept(type, 0);
        type.methods.forEach(method -> put(numbers, method));
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        type.accept(writer);
        return writer.toByteArray();
    }

    private static void put(Map<Integer, Integer> numbers, MethodNode method) {
        for (AbstractInsnNode each : method.instructions.toArray()) {
            if (each instanceof LineNumberNode line && numbers.containsKey(line.line)) {
                AbstractInsnNode first = firstInstruction(line);
                if (first != null) {
                    put(call(numbers.get(line.line)), first, method.instructions);
                }
            }
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
    private static void put(InsnList probe, AbstractInsnNode first, InsnList code) {
        if (first.getOpcode() == Opcodes.NEW) {
            code.insert(first, probe);
        } else {
            code.insertBefore(first, probe);
        }
    }

    private static InsnList call(int number) {
        InsnList code = new InsnList();
        code.add(new LdcInsnNode(number));
        code.add(new MethodInsnNode(Opcodes.INVOKESTATIC, PROBES, "reached", "(I)V", false));
        return code;
    }
}
