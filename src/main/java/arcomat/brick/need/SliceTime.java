package arcomat.brick.need;

import arcomat.brick.api.BrickCost;
import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * How long a slice takes at most. While it computes, the thread of leJOS that regulates the motors
 * interrupts it every four milliseconds, for a time that grows with the number of motors; while it
 * waits for a sensor on a bus, only the last such interruption can make it longer.
 */
record SliceTime(Code code, LibraryCost library, Entry entry) {

    private static final String SHAFT = "arcomat/nxt/Shaft";
    private static final String ROBOT = "arcomat/nxt/Robot";
    private static final String LINK = "arcomat/nxt/Link";
    private static final String THREAD = "java/lang/Thread";
    private static final String MOTOR = "lejos/nxt/Motor";
    private static final int MOTORS = 3;

    /** How many rows a robot shows that watches itself, and what it takes to come to each. */
    private static final int ROWS = 3;

    private static final int ROW = 50;

    /** From one regulation to the next, in microseconds, and what it takes: counted in its body. */
    private static final long REGULATION = 4000;

    private static final long REGULATION_ITSELF = 110;
    private static final long REGULATION_OF_A_MOTOR = 490;

    /**
     * In microseconds, from one look at the clock to the next.
     *
     * @throws Unknown if that cannot be told
     */
    long worst() {
        MethodNode slices = entry.slices();
        refuseThreads();
        long motors = motors();
        long regulation = motors == 0 ? 0 : REGULATION_ITSELF + REGULATION_OF_A_MOTOR * motors;
        Times times = new Times(code, library, regulation, Map.of());
        long parts = REGULATION * growth() + shown(times);
        for (AbstractInsnNode each : slices.instructions) {
            parts = Math.addExact(parts, isSlice(each) ? slice(each, times) : times.of(each));
        }
        return parts / (REGULATION - regulation);
    }

    private RobotMonitors monitors() {
        return new RobotMonitors(code, library);
    }

    /** The longest slice may be one in which monitors make all their arrays longer. */
    private long growth() {
        MethodName copy =
                new MethodName(
                        "java/lang/System",
                        "arraycopy",
                        "(Ljava/lang/Object;ILjava/lang/Object;II)V");
        return monitors().growths(entry.main()) * library.time(copy);
    }

    /** What one of the monitors shows in each slice, after a violation or when it has given up. */
    private long shown(Times times) {
        MethodName row = new MethodName("arcomat/nxt/Row", "show", "(Ljava/lang/String;)V");
        return monitors().show() ? ROWS * (times.of(row) + REGULATION * ROW) : 0;
    }

    private static boolean isSlice(AbstractInsnNode each) {
        return each instanceof MethodInsnNode call
                && call.name.equals("slice")
                && call.desc.equals("()V");
    }

    /**
     * Along the longest branches, or the longest ones that can come together if these are found.
     */
    private long slice(AbstractInsnNode call, Times times) {
        Optional<String> robot = entry.robot();
        if (robot.isPresent() && reaction(robot.get()).isPresent()) {
            return events(robot.get(), times);
        }
        long branches = times.of(call);
        if (robot.isEmpty()) {
            return branches;
        }
        try {
            long found = new SliceSearch(code, library, robot.get()).heaviest(times);
            return Math.min(branches, times.own(call) + found);
        } catch (Unknown e) {
            return branches;
        }
    }

    private long events(String robot, Times times) {
        long heaviest = 0;
        for (Store each : new SliceSearch(code, library, robot).started()) {
            EventTime time = new EventTime(code, times, each);
            heaviest = Math.max(heaviest, time.of(reaction(robot).orElseThrow()));
        }
        return heaviest;
    }

    private Optional<MethodInsnNode> reaction(String robot) {
        return code.method(new MethodName(robot, "slice", "()V")).flatMap(EventTime::reaction);
    }

    /** Whether a slice lasts until no event waits. */
    boolean isDrivenByEvents() {
        return entry.isRobot() && entry.robot().flatMap(this::reaction).isPresent();
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

    /**
     * How long methods take at most, in parts of a microsecond. Regulation lets a program compute
     * for some of these parts of each microsecond. What waits for a bus waits on meanwhile, and
     * goes on when the regulation has ended that runs at the end of the wait.
     */
    private static final class Times extends MethodWeights {
        private final long regulation;

        /**
         * @param regulation in which the program does not compute, of {@link #REGULATION}
         */
        Times(Code code, LibraryCost library, long regulation, Map<String, Long> sizes) {
            super(code, library, sizes);
            this.regulation = regulation;
        }

        @Override
        protected MethodWeights ofMonitor(Code alone, Map<String, Long> ofIts) {
            return new Times(alone, library, regulation, ofIts);
        }

        @Override
        protected boolean isLookedInto(MethodName method) {
            return library.measured(method).isEmpty();
        }

        @Override
        protected long own(AbstractInsnNode instruction) {
            if (instruction.getOpcode() < 0) {
                return 0; // a label or a line
            }
            return REGULATION
                    * (instruction instanceof MethodInsnNode
                            ? BrickCost.MICROSECONDS_PER_CALL
                            : BrickCost.MICROSECONDS_PER_BYTECODE);
        }

        @Override
        protected long ofLibrary(MethodName method) {
            long idle = library.idle(method);
            long wait = idle == 0 ? 0 : idle + regulation;
            return (REGULATION - regulation) * wait + REGULATION * (library.time(method) - idle);
        }
    }
}
