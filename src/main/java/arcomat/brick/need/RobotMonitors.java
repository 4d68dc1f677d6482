package arcomat.brick.need;

import arcomat.brick.need.flow.Constants;
import arcomat.brick.need.flow.MethodName;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The monitors of a robot that watches itself. */
record RobotMonitors(Code code, LibraryCost library) {
    private static final String MONITOR = "arcomat/rt/Monitor";
    private static final String WATCHED_ROBOT = "arcomat/nxt/WatchedRobot";
    private static final String GO_ON = "goOn";
    private static final Set<String> ASKING = Set.of("demand", GO_ON);

    /** Where the text comes from that says what is violated. */
    static final List<MethodName> OF_VIOLATION =
            List.of(
                    new MethodName("arcomat/rt/Accusation", "unexpected", "(Z)Ljava/lang/String;"),
                    new MethodName(
                            "arcomat/rt/Ending",
                            "text",
                            "(Larcomat/rt/Requirement;Ljava/lang/String;)Ljava/lang/String;"),
                    new MethodName(MONITOR, "violate", "(Ljava/lang/String;)V"));

    /** Their classes. */
    List<String> classes() {
        return code.subtypes(MONITOR).stream()
                .filter(each -> (code.type(each).orElseThrow().access & Opcodes.ACC_ABSTRACT) == 0)
                .toList();
    }

    /** The class of the monitor that is asked about a slice, where a call does that. */
    Optional<String> asked(MethodInsnNode call) {
        return ASKING.contains(call.name)
                        && call.desc.equals("(L" + MONITOR + ";)V")
                        && code.withSupertypes(call.owner).contains(WATCHED_ROBOT)
                ? Optional.ofNullable(Constants.before(call)).flatMap(this::read)
                : Optional.empty();
    }

    /** Whether a call asks a monitor after whose violation the robot goes on. */
    boolean goesOn(MethodInsnNode call) {
        return call.name.equals(GO_ON) && asked(call).isPresent();
    }

    /** Whether the robot may have to show something while it goes on. */
    boolean show() {
        return classes().stream().anyMatch(each -> size(each).mayGiveUp())
                || code.classes().stream()
                        .flatMap(node -> node.methods.stream())
                        .flatMap(method -> Arrays.stream(method.instructions.toArray()))
                        .anyMatch(each -> each instanceof MethodInsnNode call && goesOn(call));
    }

    private Optional<String> read(AbstractInsnNode instruction) {
        return instruction instanceof FieldInsnNode field
                ? classes().stream().filter(each -> field.desc.equals("L" + each + ";")).findFirst()
                : Optional.empty();
    }

    /** The program with no other monitor. */
    Code alone(String monitor) {
        return code.without(classes().stream().filter(each -> !each.equals(monitor)).toList());
    }

    /** How large a monitor gets at most. */
    MonitorSize size(String monitor) {
        return MonitorSize.of(monitor, code, library);
    }

    /** Bytes of the arrays of all of them. */
    long bytes(MethodName main) {
        return classes().stream().mapToLong(each -> number(each, main) * size(each).bytes()).sum();
    }

    /** How often they make an array longer at most, all together. */
    long growths(MethodName main) {
        return classes().stream()
                .mapToLong(each -> number(each, main) * size(each).growths())
                .sum();
    }

    private long number(String monitor, MethodName main) {
        return new Counts(code, library, monitor).of(main);
    }
}
