package arcomat.sim.load;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.IntInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Whether a program has the form of those that the tool makes, so that a thread in its {@link
 * SliceLoop} can have nothing else on its stack:
 *
 * <ul>
 *   <li>main does nothing but make a robot and run it, and the robot runs the loop;
 *   <li>loop and clock are left and entered in one place each, and hold no lock there;
 *   <li>nobody else calls main, or runs a robot.
 * </ul>
 */
final class GeneratedForm {
    private static final String MAIN = "main";
    private static final String OF_MAIN = "([Ljava/lang/String;)V";

    private final Map<String, ClassNode> types = new HashMap<>();
    private final String mainClass;

    private GeneratedForm(Program program) {
        mainClass = program.mainClass().replace('.', '/');
        for (byte[] classFile : program.classes().values()) {
            ClassNode type = new ClassNode();
            new ClassReader(classFile)
                    .accept(type, ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
            types.put(type.name, type);
        }
    }

    /** Classes that are none are no such program. */
    static boolean isOf(Program program) {
        try {
            return new GeneratedForm(program).holds();
        } catch (RuntimeException e) {
            return false; // who needs the class will be told
        }
    }

    private boolean holds() {
        return mainRunsRobot()
                && isLeftInOnePlace(SliceLoop.RUN, SliceLoop.LOOP)
                && isLeftInOnePlace(SliceLoop.LOOP, SliceLoop.WAIT)
                && isLeftInOnePlace(SliceLoop.WAIT, SliceLoop.SLEEP)
                && nobodyElseEnters();
    }

    /** {@code new Program().run(100);} and nothing else. */
    private boolean mainRunsRobot() {
        ClassNode type = type(mainClass);
        for (MethodNode method : type.methods) {
            if (method.name.equals(MAIN) && method.desc.equals(OF_MAIN)) {
                return holdsNoLock(method) && runsRobot(instructions(method));
            }
        }
        return false;
    }

    /** One that is missing has nothing in it. */
    private ClassNode type(String name) {
        return types.getOrDefault(name, new ClassNode());
    }

    private boolean runsRobot(List<AbstractInsnNode> code) {
        return code.size() == 6
                && code.get(0).getOpcode() == Opcodes.NEW
                && code.get(1).getOpcode() == Opcodes.DUP
                && code.get(2) instanceof MethodInsnNode made
                && made.name.equals("<init>")
                && made.desc.equals("()V")
                && isNumber(code.get(3))
                && code.get(4) instanceof MethodInsnNode run
                && run.getOpcode() == Opcodes.INVOKEVIRTUAL
                && SliceLoop.RUN.isOf(run)
                && isRobot(run.owner)
                && code.get(5).getOpcode() == Opcodes.RETURN;
    }

    private static boolean isNumber(AbstractInsnNode instruction) {
        int opcode = instruction.getOpcode();
        return instruction instanceof IntInsnNode && opcode != Opcodes.NEWARRAY
                || opcode >= Opcodes.ICONST_0 && opcode <= Opcodes.ICONST_5;
    }

    private static List<AbstractInsnNode> instructions(MethodNode method) {
        List<AbstractInsnNode> code = new ArrayList<>();
        for (AbstractInsnNode each : method.instructions) {
            if (each.getOpcode() >= 0) {
                code.add(each);
            }
        }
        return code;
    }

    /** Its way to run is the one that is looked at here: nothing can override it. */
    private boolean isRobot(String type) {
        String each = type;
        while (types.containsKey(each) && !each.equals(SliceLoop.RUN.owner())) {
            each = types.get(each).superName;
        }
        return each.equals(SliceLoop.RUN.owner());
    }

    private boolean isLeftInOnePlace(SliceLoop.Call entered, SliceLoop.Call left) {
        ClassNode type = type(entered.owner());
        for (MethodNode method : type.methods) {
            if (entered.isOf(method)) {
                return isAlone(type, method)
                        && holdsNoLock(method)
                        && SliceLoop.calls(method, left).size() == 1;
            }
        }
        return false;
    }

    private static boolean isAlone(ClassNode type, MethodNode method) {
        return ((type.access | method.access) & Opcodes.ACC_FINAL) != 0
                || (method.access & Opcodes.ACC_PRIVATE) != 0;
    }

    private static boolean holdsNoLock(MethodNode method) {
        return (method.access & Opcodes.ACC_SYNCHRONIZED) == 0
                && instructions(method).stream()
                        .noneMatch(each -> each.getOpcode() == Opcodes.MONITORENTER);
    }

    private boolean nobodyElseEnters() {
        int runs = 0;
        int loops = 0;
        for (ClassNode type : types.values()) {
            for (MethodNode method : type.methods) {
                for (AbstractInsnNode each : instructions(method)) {
                    if (each.getOpcode() == Opcodes.INVOKEDYNAMIC) {
                        return false; // may call anything
                    }
                    if (each instanceof MethodInsnNode call) {
                        runs += SliceLoop.RUN.isOf(call) ? 1 : 0;
                        loops += SliceLoop.LOOP.isTo(call) ? 1 : 0;
                        if (call.name.equals(MAIN) && call.desc.equals(OF_MAIN)) {
                            return false;
                        }
                    }
                }
            }
        }
        return runs == 1 && loops == 1;
    }
}
