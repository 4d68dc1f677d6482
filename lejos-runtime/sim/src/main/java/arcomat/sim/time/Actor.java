package arcomat.sim.time;

/** Something that is due at a moment of virtual time. */
public abstract class Actor {
    /** What is due at the same moment acts in this order. */
    public enum Rank {
        /** Changes of the surroundings: a program that samples at this moment sees them. */
        WORLD,
        /** Threads of programs. */
        PROGRAM,
        /** Whoever steers the run: sees everything that happened at this moment. */
        CONTROLLER
    }

    final Rank rank;
    long due = VirtualTime.NEVER;

    /** Among equals the one that has waited longest acts first. */
    long turn;

    Actor(Rank rank) {
        this.rank = rank;
    }

    final boolean isBefore(Actor other) {
        if (due != other.due) {
            return due < other.due;
        }
        return rank != other.rank ? rank.compareTo(other.rank) < 0 : turn < other.turn;
    }
}
