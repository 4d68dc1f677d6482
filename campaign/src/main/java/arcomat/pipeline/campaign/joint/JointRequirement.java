package arcomat.pipeline.campaign.joint;

import java.util.List;

/**
 * A requirement on several robots, as generated code.
 *
 * @param column of the table
 * @param monitors full names of the classes that watch: one for each automaton
 * @param arguments of their constructors, in the order of these, as texts
 * @param ports what they look at
 */
public record JointRequirement(
        String column, List<String> monitors, List<String> arguments, List<WatchedPort> ports) {
    public JointRequirement {
        monitors = List.copyOf(monitors);
        arguments = List.copyOf(arguments);
        ports = List.copyOf(ports);
    }

    /**
     * A port of a requirement.
     *
     * @param field of the monitor that takes its message
     * @param flag field that says whether there is one; empty where the message says it itself
     * @param type as models write it; of those that expressions over the world have, else of an
     *     enum
     * @param total whether it wants a message in every slice
     */
    public record WatchedPort(String name, String field, String flag, String type, boolean total) {}
}
