package arcomat.brick.need.flow;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.IincInsnNode;
import org.objectweb.asm.tree.JumpInsnNode;
import org.objectweb.asm.tree.VarInsnNode;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * How often a loop goes round that counts: a local variable starts at constants, each round changes
 * it by the same step and compares it with a constant. Of any other loop nothing is said.
 *
 * @param loop a knot of instructions
 * @param head the only one of them that is reached from outside
 */
public record LoopCounter(FlowGraph graph, BitSet loop, int head) {

    /** At most so many times the end leads back to the head. */
    public OptionalLong rounds() {
        return loop.stream()
                .mapToObj(this::rounds)
                .filter(OptionalLong::isPresent)
                .mapToLong(OptionalLong::getAsLong)
                .min();
    }

    /** As far as an instruction ends the loop. */
    private OptionalLong rounds(int position) {
        if (!(graph.instruction(position) instanceof JumpInsnNode jump) || !isPassed(position)) {
            return OptionalLong.empty();
        }
        boolean jumpStays = loop.get(graph.position(jump.label));
        boolean goingOnStays = position + 1 < graph.size() && loop.get(position + 1);
        if (jumpStays == goingOnStays) {
            return OptionalLong.empty();
        }
        return comparison(jump, jumpStays).map(this::rounds).orElse(OptionalLong.empty());
    }

    /**
     * The loop goes on while this holds.
     *
     * @param isUpper whether the variable is to be below the limit, and not above
     * @param limit the first value that ends the loop
     */
    private record Comparison(int variable, boolean isUpper, long limit) {}

    private static Optional<Comparison> comparison(JumpInsnNode jump, boolean isStay) {
        int opcode = jump.getOpcode();
        AbstractInsnNode right = Constants.before(jump);
        boolean isWithZero = opcode >= Opcodes.IFLT && opcode <= Opcodes.IFLE;
        boolean isOfTwo = opcode >= Opcodes.IF_ICMPLT && opcode <= Opcodes.IF_ICMPLE;
        OptionalInt limit = isWithZero ? OptionalInt.of(0) : Constants.pushed(right);
        if (right == null || limit.isEmpty() || !isWithZero && !isOfTwo) {
            return Optional.empty();
        }
        AbstractInsnNode left = isWithZero ? right : Constants.before(right);
        if (!(left instanceof VarInsnNode load) || load.getOpcode() != Opcodes.ILOAD) {
            return Optional.empty();
        }
        int kind = opcode - (isWithZero ? Opcodes.IFLT : Opcodes.IF_ICMPLT) + Opcodes.IFLT;
        return Optional.of(comparison(load.var, kind, isStay, limit.getAsInt()));
    }

    private static Comparison comparison(int variable, int kind, boolean isStay, long number) {
        return switch (kind) {
            case Opcodes.IFLT -> new Comparison(variable, isStay, number - (isStay ? 0 : 1));
            case Opcodes.IFGE -> new Comparison(variable, !isStay, number - (isStay ? 1 : 0));
            case Opcodes.IFGT -> new Comparison(variable, !isStay, number + (isStay ? 0 : 1));
            default -> new Comparison(variable, isStay, number + (isStay ? 1 : 0));
        };
    }

    private OptionalLong rounds(Comparison goesOn) {
        OptionalInt step = step(goesOn.variable());
        if (step.isEmpty() || step.getAsInt() == 0 || step.getAsInt() > 0 != goesOn.isUpper()) {
            return OptionalLong.empty();
        }
        List<Integer> starts = starts(goesOn.variable());
        if (starts.isEmpty()) {
            return OptionalLong.empty();
        }
        long width = Math.abs((long) step.getAsInt());
        long rounds = 0;
        for (int start : starts) {
            long way = goesOn.isUpper() ? goesOn.limit() - start : start - goesOn.limit();
            rounds = Math.max(rounds, (way + width - 1) / width);
        }
        return OptionalLong.of(rounds);
    }

    /** What each round adds, once and for certain. */
    private OptionalInt step(int variable) {
        int found = -1;
        for (int i = loop.nextSetBit(0); i >= 0; i = loop.nextSetBit(i + 1)) {
            if (changes(i, variable)) {
                if (found >= 0 || !(graph.instruction(i) instanceof IincInsnNode)) {
                    return OptionalInt.empty();
                }
                found = i;
            }
        }
        return found >= 0 && isPassed(found) && isOutsideOfInnerLoops(found)
                ? OptionalInt.of(((IincInsnNode) graph.instruction(found)).incr)
                : OptionalInt.empty();
    }

    private boolean changes(int position, int variable) {
        AbstractInsnNode each = graph.instruction(position);
        return each instanceof IincInsnNode step && step.var == variable
                || each instanceof VarInsnNode store
                        && store.var == variable
                        && store.getOpcode() == Opcodes.ISTORE;
    }

    /** Whether each round comes past an instruction. */
    private boolean isPassed(int position) {
        if (position == head) {
            return true;
        }
        BitSet others = (BitSet) loop.clone();
        others.clear(position);
        return !isOnCircle(head, others);
    }

    /** An inner loop may step on more often than once a round, and past the test. */
    private boolean isOutsideOfInnerLoops(int position) {
        BitSet inner = (BitSet) loop.clone();
        inner.clear(head);
        return position == head || !isOnCircle(position, inner);
    }

    private boolean isOnCircle(int position, BitSet among) {
        return graph.among(among).reachableFrom(position).get(position);
    }

    /** The constants that the variable may have when the loop begins; none if there are others. */
    private List<Integer> starts(int variable) {
        List<Integer> starts = new ArrayList<>();
        BitSet seen = new BitSet();
        Deque<Integer> open = new ArrayDeque<>();
        outsideOf(head).forEach(open::push);
        while (!open.isEmpty()) {
            int each = open.pop();
            if (seen.get(each)) {
                continue;
            }
            seen.set(each);
            if (changes(each, variable)) {
                OptionalInt start = stored(each);
                if (start.isEmpty()) {
                    return List.of();
                }
                starts.add(start.getAsInt());
            } else if (each == 0) {
                return List.of(); // a parameter, on the first way to here
            } else {
                graph.before(each).forEach(open::push);
            }
        }
        return starts;
    }

    private List<Integer> outsideOf(int position) {
        return graph.before(position).stream().filter(each -> !loop.get(each)).toList();
    }

    /** The constant that is pushed right before it is stored. */
    private OptionalInt stored(int position) {
        AbstractInsnNode each = graph.instruction(position);
        return each instanceof VarInsnNode && graph.before(position).equals(List.of(position - 1))
                ? Constants.pushed(graph.instruction(position - 1))
                : OptionalInt.empty();
    }
}
