package arcomat.analysis.game;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * Which requirements have to do with each other, because they decide about a common output. Those
 * that do not are satisfied independently: a system answers each group on its own.
 *
 * @param neighbours per requirement those that it has to do with, itself included
 */
public record Groups(List<BitSet> neighbours) {

    /**
     * @param decided per requirement the numbers of the output ports that it decides about
     */
    public static Groups byOutputs(List<BitSet> decided) {
        List<BitSet> neighbours = new ArrayList<>();
        for (BitSet one : decided) {
            BitSet near = new BitSet();
            for (int other = 0; other < decided.size(); other++) {
                if (one.intersects(decided.get(other))) {
                    near.set(other);
                }
            }
            neighbours.add(near);
        }
        return new Groups(neighbours);
    }

    /** All of them have to do with each other. */
    public static Groups one(int requirements) {
        List<BitSet> neighbours = new ArrayList<>();
        for (int i = 0; i < requirements; i++) {
            BitSet all = new BitSet();
            all.set(0, requirements);
            neighbours.add(all);
        }
        return new Groups(neighbours);
    }

    boolean areNeighbours(int one, int other) {
        return neighbours.get(one).get(other);
    }

    /** The parts of a set of requirements that have nothing to do with each other. */
    List<BitSet> of(BitSet requirements) {
        List<BitSet> groups = new ArrayList<>();
        BitSet open = (BitSet) requirements.clone();
        while (!open.isEmpty()) {
            BitSet group = new BitSet();
            BitSet border = new BitSet();
            border.set(open.nextSetBit(0));
            while (!border.isEmpty()) {
                int next = border.nextSetBit(0);
                group.set(next);
                border.or(neighbours.get(next));
                border.and(requirements);
                border.andNot(group);
            }
            groups.add(group);
            open.andNot(group);
        }
        return groups;
    }
}
