package arcomat.brick.need;

import arcomat.brick.need.flow.Constants;
import arcomat.brick.need.flow.MethodName;
import arcomat.brick.need.flow.Unknown;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TypeInsnNode;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** Where a program starts, and what it says there about its slices. */
record Entry(Code code) {

    /** NEW, DUP, the constructor, the cycle, run, RETURN. */
    private static final int LENGTH_OF_MAIN = 6;

    private static final String ROBOT = "arcomat/nxt/Robot";

    /** Runs one slice after the other. */
    static final MethodName SLICES = new MethodName(ROBOT, "runSlices", "(Larcomat/rt/Cycle;)V");

    /**
     * The method that the machine calls.
     *
     * @throws Unknown if there is none, or more than one
     */
    MethodName main() {
        List<MethodName> mains = mains();
        if (mains.size() != 1) {
            throw new Unknown(
                    mains.isEmpty()
                            ? "the jar has no main method"
                            : "the jar has several main methods");
        }
        return mains.get(0);
    }

    private List<MethodName> mains() {
        return code.classes().stream()
                .map(node -> new MethodName(node.name, "main", "([Ljava/lang/String;)V"))
                .filter(name -> code.method(name).isPresent())
                .toList();
    }

    /** Whether the runtime repeats slices; other programs have loops of their own. */
    boolean isRobot() {
        return run() != null;
    }

    /** The body of the loop that runs one slice after the other. */
    MethodNode slices() {
        main();
        return code.method(SLICES)
                .filter(method -> isRobot())
                .orElseThrow(() -> new Unknown("the program has a loop of its own"));
    }

    /** The class of the robot, if all that the main method does is to make one and to run it. */
    Optional<String> robot() {
        List<AbstractInsnNode> all =
                Arrays.stream(code.method(main()).orElseThrow().instructions.toArray())
                        .filter(each -> each.getOpcode() >= 0)
                        .toList();
        return all.size() == LENGTH_OF_MAIN
                        && all.get(0) instanceof TypeInsnNode made
                        && all.get(2) instanceof MethodInsnNode constructor
                        && constructor.desc.equals("()V")
                        && all.get(LENGTH_OF_MAIN - 2) == run()
                ? Optional.of(made.desc)
                : Optional.empty();
    }

    /** From one slice to the next, in milliseconds, if it is written as a number. */
    OptionalInt cycle() {
        MethodInsnNode run = run();
        return run == null ? OptionalInt.empty() : Constants.pushed(Constants.before(run));
    }

    private @Nullable MethodInsnNode run() {
        if (mains().size() != 1) {
            return null;
        }
        for (AbstractInsnNode each : code.method(main()).orElseThrow().instructions) {
            if (each instanceof MethodInsnNode call
                    && call.getOpcode() == Opcodes.INVOKEVIRTUAL
                    && call.name.equals("run")
                    && call.desc.equals("(I)V")
                    && code.withSupertypes(call.owner).contains(ROBOT)) {
                return call;
            }
        }
        return null;
    }
}
