package arcomat.world.contact;

import java.util.ArrayList;
import java.util.List;

/**
 * Where bodies come to in one step. Those that would be in one place are held where they were,
 * where they did not overlap.
 */
public final class Crowd {
    private final List<Round> before = new ArrayList<>();
    private final List<Round> now = new ArrayList<>();

    /** A body more; one that does not move is given the same place twice. */
    public void add(Round was, Round comes) {
        before.add(was);
        now.add(comes);
    }

    /** Where the body with this index is now. */
    public Round now(int index) {
        return now.get(index);
    }

    /** Whether a body is where it was. */
    public boolean isHeld(int index) {
        return now.get(index).equals(before.get(index));
    }

    /** Whether it had moved. */
    public boolean hold(int index) {
        return !now.set(index, before.get(index)).equals(before.get(index));
    }

    /** Holds bodies until no two overlap. Who is held may be in the way of others. */
    public void settle() {
        boolean changes = true;
        while (changes) {
            changes = false;
            for (int i = 0; i < now.size(); i++) {
                for (int j = 0; j < i; j++) {
                    if (overlapMore(i, j)) {
                        changes |= hold(i);
                        changes |= hold(j);
                    }
                }
            }
        }
    }

    /** Those that overlapped before may go apart. */
    private boolean overlapMore(int one, int other) {
        double gap = now.get(one).gap(now.get(other));
        return gap < 0 && gap < before.get(one).gap(before.get(other));
    }
}
