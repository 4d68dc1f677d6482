package arcomat.sim.load;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.ArrayList;
import java.util.List;

/**
 * The loop of the programs that the tool makes: main runs a robot, which waits in one place for
 * each slice. A thread that waits there has nothing on its stack but these calls, and can rest.
 */
final class SliceLoop {
    static final String ROBOT = "arcomat.nxt.Robot";

    /** What a robot's loop is in, from outside. */
    static final Call RUN = new Call("arcomat/nxt/Robot", "run", "(I)V");

    static final Call LOOP = new Call("arcomat/nxt/Robot", "runSlices", "(Larcomat/rt/Cycle;)V");
    static final Call WAIT = new Call("arcomat/rt/Cycle", "await", "()Z");
    static final Call SLEEP = new Call("java/lang/Thread", "sleep", "(J)V");

    private static final Call SIMULATED_SLEEP =
            new Call("arcomat/sim/inside/BrickThreads", "sleep", "(J)V");
    private static final String CLOCK = "arcomat.rt.Cycle";

    /** The clock is asked to wait elsewhere, too. */
    private static final String RESTING = "$resting";

    private SliceLoop() {}

    /** A method as a class file names it. */
    record Call(String owner, String name, String descriptor) {
        boolean isTo(MethodInsnNode call) {
            return call.owner.equals(owner) && declares(call.name, call.desc);
        }

        boolean isOf(MethodNode method) {
            return declares(method.name, method.desc);
        }

        /** Whether a call may be one of this, whatever type it names. */
        boolean isOf(MethodInsnNode call) {
            return declares(call.name, call.desc);
        }

        private boolean declares(String otherName, String otherDescriptor) {
            return name.equals(otherName) && descriptor.equals(otherDescriptor);
        }
    }

    /** The calls of a method in another one. */
    static List<MethodInsnNode> calls(MethodNode method, Call called) {
        List<MethodInsnNode> calls = new ArrayList<>();
        for (AbstractInsnNode each : method.instructions) {
            if (each instanceof MethodInsnNode call && called.isTo(call)) {
                calls.add(call);
            }
        }
        return calls;
    }

    /** What a method is called in its class file. */
    static String written(String method) {
        return method.endsWith(RESTING)
                ? method.substring(0, method.length() - RESTING.length())
                : method;
    }

    /**
     * A class of a program, such that its thread rests between slices.
     *
     * @param classFile as bricks load it, with its calls redirected
     * @throws Unrepeatable where that is not possible
     */
    static byte[] resting(String name, byte[] classFile) {
        if (!name.equals(ROBOT) && !name.equals(CLOCK)) {
            return classFile;
        }
        ClassNode type = new ClassNode();
        new ClassReader(classFile).accept(type, ClassReader.SKIP_FRAMES);
        if (name.equals(ROBOT)) {
            changeRobot(type);
        } else {
            changeClock(type);
        }
        ClassWriter writer = new ExactFrames();
        type.accept(writer);
        return writer.toByteArray();
    }

    private static void changeRobot(ClassNode robot) {
        MethodNode run = method(robot, RUN);
        ReentrantMethod.change(robot.name, run, call(run, LOOP), true);
        MethodNode loop = method(robot, LOOP);
        MethodInsnNode wait = call(loop, WAIT);
        wait.name += RESTING;
        ReentrantMethod.change(robot.name, loop, wait, false);
    }

    private static void changeClock(ClassNode clock) {
        MethodNode usual = method(clock, WAIT);
        MethodNode resting =
                new MethodNode(
                        Opcodes.ASM9,
                        usual.access | Opcodes.ACC_SYNTHETIC,
                        usual.name + RESTING,
                        usual.desc,
                        null,
                        null);
        usual.accept(resting);
        MethodInsnNode sleep = call(resting, SIMULATED_SLEEP);
        sleep.owner = "arcomat/sim/inside/BrickRests";
        ReentrantMethod.change(clock.name, resting, sleep, false);
        clock.methods.add(resting);
    }

    private static MethodNode method(ClassNode type, Call call) {
        return type.methods.stream().filter(call::isOf).findFirst().orElseThrow();
    }

    private static MethodInsnNode call(MethodNode method, Call called) {
        return calls(method, called).get(0);
    }

    /** Where it would have to know other classes, it gives up. */
    private static final class ExactFrames extends ClassWriter {
        ExactFrames() {
            super(ClassWriter.COMPUTE_FRAMES);
        }

        @Override
        protected String getCommonSuperClass(String first, String second) {
            throw new Unrepeatable("something may be a " + first + " or a " + second);
        }
    }
}
