package arcomat.sim.load;

import arcomat.brick.api.BrickCost;

import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.JumpInsnNode;
import org.objectweb.asm.tree.LookupSwitchInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.TableSwitchInsnNode;
import org.objectweb.asm.tree.TryCatchBlockNode;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * The stretches of a method that run from their begin to their end.
 *
 * @param costs in microseconds, by the first instruction of each that is reached by a jump or
 *     behind one
 * @param first what the stretch costs with which the method begins; 0 if that can be jumped to
 */
record Blocks(Map<AbstractInsnNode, Integer> costs, int first) {
    static Blocks of(MethodNode method) {
        Set<AbstractInsnNode> targets = targets(method);
        Map<AbstractInsnNode, Integer> costs = costs(method, targets);
        AbstractInsnNode each = method.instructions.getFirst();
        boolean isTarget = false;
        for (; each.getOpcode() < 0; each = each.getNext()) {
            isTarget |= targets.contains(each);
        }
        return new Blocks(costs, isTarget ? 0 : Objects.requireNonNull(costs.remove(each)));
    }

    private static Map<AbstractInsnNode, Integer> costs(
            MethodNode method, Set<AbstractInsnNode> targets) {
        Map<AbstractInsnNode, Integer> costs = new LinkedHashMap<>();
        AbstractInsnNode first = null;
        boolean begins = true;
        for (AbstractInsnNode each : method.instructions) {
            begins |= targets.contains(each);
            if (each.getOpcode() >= 0) {
                if (begins) {
                    first = each;
                }
                begins = each instanceof JumpInsnNode;
                costs.merge(first, cost(each), Integer::sum);
            }
        }
        return costs;
    }

    private static int cost(AbstractInsnNode instruction) {
        return instruction instanceof MethodInsnNode
                ? BrickCost.MICROSECONDS_PER_CALL
                : BrickCost.MICROSECONDS_PER_BYTECODE;
    }

    private static Set<AbstractInsnNode> targets(MethodNode method) {
        Set<AbstractInsnNode> targets = new HashSet<>();
        for (TryCatchBlockNode block : method.tryCatchBlocks) {
            targets.add(block.handler);
        }
        for (AbstractInsnNode each : method.instructions) {
            if (each instanceof JumpInsnNode jump) {
                targets.add(jump.label);
            } else if (each instanceof TableSwitchInsnNode table) {
                targets.addAll(table.labels);
                targets.add(table.dflt);
            } else if (each instanceof LookupSwitchInsnNode lookup) {
                targets.addAll(lookup.labels);
                targets.add(lookup.dflt);
            }
        }
        return targets;
    }
}
