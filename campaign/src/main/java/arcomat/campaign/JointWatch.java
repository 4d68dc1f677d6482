package arcomat.campaign;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A requirement of the models on what several robots do: the event is that a run violates it.
 *
 * @param name of the column
 * @param requirement as {@code generate --monitor} names one
 * @param bindings what the ports of the requirement show, in the order of the text
 * @param place of the requirement in the campaign
 */
public record JointWatch(String name, String requirement, List<Binding> bindings, Span place) {
    public JointWatch {
        bindings = List.copyOf(bindings);
    }

    /**
     * What a port of the requirement shows.
     *
     * @param port its name
     * @param source a port of a robot, or an expression over what can be read in the world
     * @param place of the port's name in the campaign
     */
    public record Binding(String port, Span source, Span place) {
        private static final Pattern ROBOT_PORT =
                Pattern.compile("([A-Za-z][\\w-]*)\\.([A-Za-z][\\w.\\[\\]]*)\\.([A-Za-z]\\w*)");

        /** The port of a robot that is named; else it is an expression. */
        public Optional<RobotPort> robotPort() {
            Matcher matcher = ROBOT_PORT.matcher(source.text());
            return matcher.matches()
                    ? Optional.of(
                            new RobotPort(matcher.group(1), matcher.group(2), matcher.group(3)))
                    : Optional.empty();
        }
    }

    /**
     * A port of a part of a robot's program.
     *
     * @param part path of the part in the component that the program runs
     */
    public record RobotPort(String robot, String part, String port) {
        /** As it is found in whatever robot: {@code avoidCrash.cmd}. */
        public String path() {
            return part + "." + port;
        }
    }

    Column column() {
        return new Column(name, true, requirement + " was violated");
    }
}
