package arcomat.brick.need;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.HashSet;
import java.util.Set;

/**
 * How long a slice takes at most. While it runs, the thread of leJOS that regulates the motors
 * interrupts it every four milliseconds, for a time that grows with the number of motors.
 */
final class SliceTime {
    private static final String SHAFT = "arcomat/nxt/Shaft";
    private static final String ROBOT = "arcomat/nxt/Robot";
    private static final String LINK = "arcomat/nxt/Link";
    private static final String THREAD = "java/lang/Thread";
    private static final String MOTOR = "lejos/nxt/Motor";
    private static final int MOTORS = 3;

    /** From one regulation to the next, in microseconds, and what it takes: counted in its body. */
    private static final long REGULATION = 4000;

    private static final long REGULATION_ITSELF = 110;
    private static final long REGULATION_OF_A_MOTOR = 490;

    private final Code code;
    private final Library library;
    private final Entry entry;

    SliceTime(Code code, Library library, Entry entry) {
        this.code = code;
        this.library = library;
        this.entry = entry;
    }

    /**
     * In microseconds, from one look at the clock to the next.
     *
     * @throws Unknown if that cannot be told
     */
    long worst() {
        MethodNode slices = entry.slices();
        refuseThreads();
        Times times = new Times(code, library);
        long alone = 0;
        for (AbstractInsnNode each : slices.instructions) {
            alone = Math.addExact(alone, times.of(each));
        }
        long motors = motors();
        long regulation = motors == 0 ? 0 : REGULATION_ITSELF + REGULATION_OF_A_MOTOR * motors;
        return Math.multiplyExact(alone, REGULATION) / (REGULATION - regulation);
    }

    private void refuseThreads() {
        for (String each : code.subtypes(THREAD)) {
            if (!each.equals(LINK)) {
                throw new Unknown(each.replace('/', '.') + " is a thread that runs meanwhile");
            }
        }
    }

    private long motors() {
        long shafts = new Counts(code, library, SHAFT).of(entry.main());
        Set<String> named = new HashSet<>();
        for (ClassNode node : code.classes()) {
            if (!node.name.equals(ROBOT)) {
                node.methods.forEach(method -> addMotors(method, named));
            }
        }
        return Math.min(MOTORS, shafts + named.size());
    }

    private static void addMotors(MethodNode method, Set<String> named) {
        for (AbstractInsnNode each : method.instructions) {
            if (each instanceof FieldInsnNode field
                    && field.getOpcode() == Opcodes.GETSTATIC
                    && field.owner.equals(MOTOR)) {
                named.add(field.name);
            }
        }
    }
}
