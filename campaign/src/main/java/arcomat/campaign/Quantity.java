package arcomat.campaign;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** What is asked of every run: a column of the table. */
public enum Quantity {
    /** Whether a robot ran into something. */
    COLLISION(true, "a robot ran into something"),
    /** Whether nobody moved any more, although the goal was not reached. */
    DEADLOCK(true, "nobody moved any more"),
    /** Whether a program stopped that should not. */
    FAILURE(true, "a program failed"),
    /** Whether the world's goal was reached; never, where it has none. */
    GOAL(true, "the goal was reached"),
    /** Seconds until the run was over. */
    TIME(false, "seconds until it was over"),
    /** Seconds until the world's goal was reached; infinite where it was not. */
    REACHED(false, "seconds until the goal was reached"),
    /** Cups that drinkers have taken. */
    DELIVERED(false, "cups delivered"),
    /** The least distance between two robots, from surface to surface, in mm. */
    DISTANCE(false, "least distance between two robots, mm"),
    /** The least distance of a robot to a wall, the edge or a person, in mm. */
    CLEARANCE(false, "least distance of a robot to anything else, mm"),
    /** Slices that took too long, of all robots. */
    LATE(false, "slices that were late"),
    /** Transitions of the models that its programs have taken, each counted once. */
    TRANSITIONS(false, "transitions of the models that were taken");

    private final boolean event;
    private final String meaning;

    Quantity(boolean event, String meaning) {
        this.event = event;
        this.meaning = meaning;
    }

    /** As a campaign and its table name it. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Whether it happens or does not: 1 or 0; else it is a number. */
    public boolean isEvent() {
        return event;
    }

    /** In a few words, for people. */
    public String meaning() {
        return meaning;
    }

    static List<String> words(boolean event) {
        return Arrays.stream(values())
                .filter(each -> each.event == event)
                .map(Quantity::word)
                .toList();
    }
}
