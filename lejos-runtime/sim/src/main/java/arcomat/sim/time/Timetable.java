package arcomat.sim.time;

/** Changes of the surroundings at moments known in advance. */
public abstract class Timetable extends Actor {
    protected Timetable() {
        this(Rank.WORLD);
    }

    protected Timetable(Rank rank) {
        super(rank);
    }

    /**
     * Does what is due now. Runs on whichever thread has the baton and must not wait.
     *
     * @return when to be called again, in microseconds; {@link VirtualTime#NEVER} for not at all
     */
    protected abstract long act();
}
