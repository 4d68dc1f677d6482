package arcomat.pipeline.brick;

import arcomat.sim.Laboratory;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.device.Limits;
import arcomat.sim.device.Observer;
import arcomat.sim.load.Program;
import arcomat.sim.script.Script;
import arcomat.sim.trace.Recorder;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A program that counts its own instructions. What leJOS does for it is not counted, for the
 * brick's leJOS is not here; the calls of it are.
 */
final class CountedProgram {
    private static final String COUNTER = Executed.class.getName().replace('.', '/');

    /** What a slice costs would delay its rows, and instructions that count would cost as well. */
    private static final Limits WITHOUT_COSTS = new Limits(50_000, true, false);

    private final Program program;
    private final int bytes;

    CountedProgram(String main, Map<String, byte[]> classes) {
        Map<String, byte[]> counting = new HashMap<>();
        int sum = 0;
        for (Map.Entry<String, byte[]> each : classes.entrySet()) {
            sum += withoutDebugging(each.getValue()).length;
            counting.put(each.getKey().replace('/', '.'), counting(each.getValue()));
        }
        counting.put(Executed.class.getName(), counter());
        this.program = new Program(main, counting);
        this.bytes = sum;
    }

    int classes() {
        return program.classes().size() - 1;
    }

    /** Of the class files, without line numbers and names of files: the linker drops them. */
    int bytes() {
        return bytes;
    }

    /**
     * @param rows what happened, as {@code run-brick} takes it down
     * @param slices how often the program slept, bytecodes and calls up to then since the first
     *     time, so that neither beginning nor end count
     */
    record Run(Recorder rows, int slices, long bytecodes, long calls) {}

    Run run(Script script, long end) {
        try (Laboratory laboratory = new Laboratory(WITHOUT_COSTS)) {
            SimulatedBrick brick = laboratory.place("robot", program);
            Recorder recorder = new Recorder();
            Counter counter = new Counter(recorder);
            brick.observe(counter);
            brick.play(script);
            laboratory.runToEnd(end);
            if (brick.outcome().failure().isPresent()) {
                throw new AssertionError(brick.outcome().failure().get());
            }
            return counter.run(recorder);
        }
    }

    /** Reads the counters whenever the program sleeps. */
    private final class Counter extends ForwardingObserver {
        private final Observer next;
        private final List<long[]> readings = new ArrayList<>();

        Counter(Observer next) {
            super(next);
            this.next = next;
        }

        @Override
        public void slept(long from, long until) {
            next.slept(from, until);
            try {
                Class<?> executed =
                        mainClass().getClassLoader().loadClass(Executed.class.getName());
                readings.add(
                        new long[] {
                            executed.getField("bytecodes").getLong(null),
                            executed.getField("calls").getLong(null)
                        });
            } catch (ReflectiveOperationException e) {
                throw new AssertionError(e);
            }
        }

        private Class<?> mainClass() {
            return StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE)
                    .walk(frames -> frames.map(f -> f.getDeclaringClass()).toList())
                    .stream()
                    .filter(c -> c.getName().equals(program.mainClass()))
                    .findFirst()
                    .orElseThrow();
        }

        Run run(Recorder recorder) {
            long[] first = readings.get(0);
            long[] last = readings.get(readings.size() - 1);
            return new Run(recorder, readings.size() - 1, last[0] - first[0], last[1] - first[1]);
        }
    }

    private static byte[] withoutDebugging(byte[] file) {
        ClassWriter writer = new ClassWriter(0);
        new ClassReader(file).accept(writer, ClassReader.SKIP_DEBUG);
        return writer.toByteArray();
    }

    private static byte[] counter() {
        try (InputStream file = Executed.class.getResourceAsStream("Executed.class")) {
            return file.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static byte[] counting(byte[] file) {
        ClassReader reader = new ClassReader(file);
        ClassWriter writer = new ClassWriter(reader, 0);
        reader.accept(
                new ClassVisitor(Opcodes.ASM9, writer) {
                    @Override
                    public MethodVisitor visitMethod(
                            int access,
                            String name,
                            String type,
                            String signature,
                            String[] exceptions) {
                        return new Counting(
                                super.visitMethod(access, name, type, signature, exceptions));
                    }
                },
                0);
        return writer.toByteArray();
    }

    /** Calls the counter before each instruction. */
    private static final class Counting extends MethodVisitor {
        Counting(MethodVisitor next) {
            super(Opcodes.ASM9, next);
        }

        private void count(String what) {
            super.visitMethodInsn(Opcodes.INVOKESTATIC, COUNTER, what, "()V", false);
        }

        @Override
        public void visitInsn(int opcode) {
            count("bytecode");
            super.visitInsn(opcode);
        }

        @Override
        public void visitIntInsn(int opcode, int operand) {
            count("bytecode");
            super.visitIntInsn(opcode, operand);
        }

        @Override
        public void visitVarInsn(int opcode, int index) {
            count("bytecode");
            super.visitVarInsn(opcode, index);
        }

        @Override
        public void visitTypeInsn(int opcode, String type) {
            count("bytecode");
            super.visitTypeInsn(opcode, type);
        }

        @Override
        public void visitFieldInsn(int opcode, String owner, String name, String type) {
            count("bytecode");
            super.visitFieldInsn(opcode, owner, name, type);
        }

        @Override
        public void visitMethodInsn(
                int opcode, String owner, String name, String type, boolean isInterface) {
            count("bytecode");
            count("call");
            super.visitMethodInsn(opcode, owner, name, type, isInterface);
        }

        @Override
        public void visitInvokeDynamicInsn(
                String name, String type, Handle bootstrap, Object... arguments) {
            throw new AssertionError("the brick has none");
        }

        @Override
        public void visitJumpInsn(int opcode, Label label) {
            count("bytecode");
            super.visitJumpInsn(opcode, label);
        }

        @Override
        public void visitLdcInsn(Object value) {
            count("bytecode");
            super.visitLdcInsn(value);
        }

        @Override
        public void visitIincInsn(int index, int increment) {
            count("bytecode");
            super.visitIincInsn(index, increment);
        }

        @Override
        public void visitTableSwitchInsn(int min, int max, Label otherwise, Label... labels) {
            count("bytecode");
            super.visitTableSwitchInsn(min, max, otherwise, labels);
        }

        @Override
        public void visitLookupSwitchInsn(Label otherwise, int[] keys, Label[] labels) {
            count("bytecode");
            super.visitLookupSwitchInsn(otherwise, keys, labels);
        }

        @Override
        public void visitMultiANewArrayInsn(String type, int dimensions) {
            count("bytecode");
            super.visitMultiANewArrayInsn(type, dimensions);
        }
    }
}
