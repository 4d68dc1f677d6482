package arcomat.brick.need;

import arcomat.brick.need.flow.Constants;
import arcomat.brick.need.flow.Unknown;
import arcomat.sim.memory.ObjectLayout;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * How large a monitor gets at most.
 *
 * @param runs that it keeps at a time
 * @param variables of the requirement
 * @param ports outputs of the requirement
 * @param messages that a run promises in a step
 * @param sent messages that all runs promise in a step
 * @param isNumbers whether all that it looks at are numbers, and no texts and objects
 */
record MonitorSize(
        long runs, long variables, long ports, long messages, long sent, boolean isNumbers) {

    private static final Set<String> WAYS = Set.of("go", "complete");

    /** With more runs, a monitor of a robot gives up: {@code arcomat.nxt.WatchedRobot}. */
    private static final long MOST_RUNS = 32;

    /** How many values there is room for in the beginning. */
    private static final int FIRST = 4;

    /** The word for how long texts are: a letter, where all that is watched are numbers. */
    static final String TEXT = "text";

    /** Runs are kept twice: those that a step begins with, and those that it leads to. */
    private static final int SETS = 2;

    private static final int LONG = 8;

    static MonitorSize of(String monitor, Code code, LibraryCost library) {
        MethodNode constructor = constructor(monitor, code);
        Shape shape = Shape.of(constructor);
        RequirementCalls ways = new RequirementCalls(code, library, monitor, WAYS);
        RequirementCalls sends = new RequirementCalls(code, library, monitor, Set.of("send"));
        long first = ways.in("<init>", constructor.desc);
        long further = Math.max(ways.in("react", "(I)V"), ways.in("complete", "(I)V"));
        long messages = Math.max(sends.in("react", "(I)V"), sends.in("complete", "(I)V"));
        long begun = sends.in("<init>", constructor.desc);
        long before = before(first, further, shape.places());
        return new MonitorSize(
                Math.max(before, Math.min(MOST_RUNS + further, before * further)),
                shape.variables(),
                shape.ports(),
                ofOneRun(code.type(monitor).orElseThrow().methods),
                Math.max((before + 1) * messages, begun),
                isNumbers(code.type(monitor).orElseThrow().methods));
    }

    /**
     * With how many runs a step begins: with one for each that the last one began with, if none
     * goes on in two ways; with one for each state, if there is nothing but states; or with what a
     * robot gives up beyond.
     */
    private static long before(long first, long further, long places) {
        return further <= 1 ? first : Math.min(Math.max(first, MOST_RUNS), places);
    }

    /**
     * What a constructor says to the runtime.
     *
     * @param places where a run may be, without variables; chaos is one
     */
    private record Shape(long places, long variables, long ports) {
        /** The names of the states, the number of variables and the names of the ports. */
        static Shape of(MethodNode constructor) {
            List<AbstractInsnNode> arrays =
                    Arrays.stream(constructor.instructions.toArray())
                            .filter(each -> each.getOpcode() == Opcodes.ANEWARRAY)
                            .toList();
            if (arrays.size() < 2) {
                throw new Unknown("a monitor is not made as others are");
            }
            AbstractInsnNode ports = Constants.before(arrays.get(1));
            long states = number(Constants.before(arrays.get(0)));
            long variables = number(Constants.before(ports));
            boolean isFew = variables == 0 && states > 0;
            return new Shape(isFew ? states + 1 : Long.MAX_VALUE, variables, number(ports));
        }

        private static long number(AbstractInsnNode pushed) {
            return Constants.pushed(pushed)
                    .orElseThrow(() -> new Unknown("a monitor is not made as others are"));
        }
    }

    private static MethodNode constructor(String monitor, Code code) {
        return code.type(monitor).orElseThrow().methods.stream()
                .filter(method -> method.name.equals("<init>"))
                .findFirst()
                .orElseThrow();
    }

    /** A run sends what is said right behind it. */
    private static long ofOneRun(List<MethodNode> methods) {
        long most = 0;
        long sent = 0;
        for (MethodNode method : methods) {
            for (AbstractInsnNode each : method.instructions) {
                if (each instanceof MethodInsnNode call) {
                    sent =
                            call.name.equals("send")
                                    ? sent + 1
                                    : WAYS.contains(call.name) ? 0 : sent;
                    most = Math.max(most, sent);
                }
            }
        }
        return most;
    }

    private static boolean isNumbers(List<MethodNode> methods) {
        return methods.stream()
                .flatMap(method -> Arrays.stream(method.instructions.toArray()))
                .noneMatch(
                        each ->
                                each instanceof MethodInsnNode call
                                        && call.desc.equals("(ILjava/lang/Object;)V"));
    }

    /** Whether there may be more runs than a robot follows. */
    boolean mayGiveUp() {
        return runs > MOST_RUNS;
    }

    /** What words in {@code library.txt} stand for; of how long texts are nothing is known. */
    Map<String, Long> words() {
        Map<String, Long> words = new HashMap<>();
        words.put("runs", runs);
        words.put("variables", variables);
        words.put("ports", ports);
        words.put("messages", Math.max(messages, 1));
        words.put("parts", Math.max(Math.max(runs, ports), Math.max(messages, 1)));
        words.put("index", Math.max(2 * FIRST, 4 * runs));
        if (isNumbers) {
            words.put(TEXT, 1L);
        }
        return words;
    }

    /**
     * Arrays that become twice as long until there is room.
     *
     * @param number of arrays
     * @param first length
     * @param needed length at the end
     */
    private record Growing(int number, long first, long needed, int element) {
        /** How often they become longer. */
        long times() {
            long times = 0;
            for (long length = first; length > 0 && length < needed; length *= 2) {
                times++;
            }
            return number * times;
        }

        /** Of those that are left behind, too: they are in memory until they are collected. */
        long bytes() {
            long bytes = 0;
            for (long length = first; length > 0 && length < needed; length *= 2) {
                bytes += ObjectLayout.array(2 * length, element);
            }
            return number * bytes;
        }
    }

    private List<Growing> growing() {
        int word = ObjectLayout.REFERENCE;
        List<Growing> all = new ArrayList<>();
        all.add(new Growing(SETS * 3, FIRST, runs, word));
        all.add(new Growing(SETS, 2 * FIRST, 2 * runs, word));
        all.add(new Growing(SETS * 2, ports, runs * ports, word));
        values(SETS, runs * variables, all);
        values(SETS, sent, all);
        values(1, ports, all);
        return all;
    }

    /** Numbers, and objects beside them if there are any. */
    private void values(int number, long needed, List<Growing> all) {
        all.add(new Growing(number, FIRST, needed, LONG));
        if (!isNumbers) {
            all.add(new Growing(number, FIRST / 2, Math.max(FIRST, needed), LONG / 2));
        }
    }

    /** Of all arrays whose length its class does not tell. */
    long bytes() {
        long entries = 2 * (SETS + 1) * ObjectLayout.array(ports, ObjectLayout.REFERENCE);
        long flags = ObjectLayout.array(ports, 1);
        return entries + flags + growing().stream().mapToLong(Growing::bytes).sum();
    }

    /** How often an array becomes longer, in all slices together. */
    long growths() {
        return growing().stream().mapToLong(Growing::times).sum();
    }
}
