package arcomat.campaign.coverage;

/**
 * A part of a robot that has an automaton.
 *
 * @param robot its name in the world
 * @param path of the part in the robot's program; empty for the whole program
 * @param automaton its place among the automata
 */
public record PartItems(String robot, String path, int automaton) {
    /** What people call it: {@code loaded.avoidCrash}. */
    public String name() {
        return path.isEmpty() ? robot : robot + "." + path;
    }
}
