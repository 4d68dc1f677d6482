package arcomat.brick.need.flow;

import arcomat.graph.Digraph;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.JumpInsnNode;
import org.objectweb.asm.tree.LabelNode;
import org.objectweb.asm.tree.LookupSwitchInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TableSwitchInsnNode;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntPredicate;

/**
 * The ways through a method, as positions of its instructions. Ways by exceptions are left out: a
 * slice that throws is the last one.
 */
public final class FlowGraph {
    private final InsnList instructions;
    private final List<List<Integer>> after = new ArrayList<>();
    private final List<List<Integer>> before = new ArrayList<>();

    public FlowGraph(MethodNode method) {
        this.instructions = method.instructions;
        for (int i = 0; i < instructions.size(); i++) {
            after.add(new ArrayList<>());
            before.add(new ArrayList<>());
        }
        for (int i = 0; i < instructions.size(); i++) {
            connect(i);
        }
    }

    private void connect(int position) {
        AbstractInsnNode each = instruction(position);
        boolean goesOn = !leaves(each) && each.getOpcode() != Opcodes.GOTO;
        if (each instanceof JumpInsnNode jump) {
            connect(position, jump.label);
        } else if (each instanceof TableSwitchInsnNode choice) {
            choice.labels.forEach(label -> connect(position, label));
            connect(position, choice.dflt);
            goesOn = false;
        } else if (each instanceof LookupSwitchInsnNode choice) {
            choice.labels.forEach(label -> connect(position, label));
            connect(position, choice.dflt);
            goesOn = false;
        }
        if (goesOn && position + 1 < size()) {
            connect(position, position + 1);
        }
    }

    private void connect(int from, LabelNode to) {
        connect(from, instructions.indexOf(to));
    }

    private void connect(int from, int to) {
        if (!after.get(from).contains(to)) {
            after.get(from).add(to);
            before.get(to).add(from);
        }
    }

    private static boolean leaves(AbstractInsnNode each) {
        return each.getOpcode() == Opcodes.ATHROW || isReturn(each);
    }

    private static boolean isReturn(AbstractInsnNode each) {
        return each.getOpcode() >= Opcodes.IRETURN && each.getOpcode() <= Opcodes.RETURN;
    }

    public int size() {
        return instructions.size();
    }

    public AbstractInsnNode instruction(int position) {
        return instructions.get(position);
    }

    public int position(AbstractInsnNode instruction) {
        return instructions.indexOf(instruction);
    }

    public List<Integer> after(int position) {
        return after.get(position);
    }

    public List<Integer> before(int position) {
        return before.get(position);
    }

    /** The ways between some instructions, which keep their numbers; the others have none. */
    public Digraph among(BitSet some) {
        Digraph ways = new Digraph(size());
        for (int i = some.nextSetBit(0); i >= 0; i = some.nextSetBit(i + 1)) {
            for (int next : after.get(i)) {
                if (some.get(next)) {
                    ways.addEdge(i, next);
                }
            }
        }
        return ways;
    }

    /**
     * What lies on a way from the start to a return.
     *
     * @param isEnd instructions that no way gets past
     */
    public BitSet useful(IntPredicate isEnd) {
        BitSet forward = new BitSet();
        if (size() > 0) {
            spread(0, after, forward, isEnd);
        }
        BitSet useful = new BitSet();
        for (int i = forward.nextSetBit(0); i >= 0; i = forward.nextSetBit(i + 1)) {
            if (isReturn(instruction(i))) {
                spread(i, before, useful, isEnd);
            }
        }
        useful.and(forward);
        return useful;
    }

    private static void spread(
            int start, List<List<Integer>> next, BitSet reached, IntPredicate isEnd) {
        List<Integer> open = new ArrayList<>(List.of(start));
        while (!open.isEmpty()) {
            int each = open.remove(open.size() - 1);
            if (!reached.get(each) && !isEnd.test(each)) {
                reached.set(each);
                open.addAll(next.get(each));
            }
        }
    }
}
