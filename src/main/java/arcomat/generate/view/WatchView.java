package arcomat.generate.view;

import java.util.List;

/**
 * A monitor inside of a program.
 *
 * @param type its class, qualified
 * @param name of the field
 * @param comment what it watches for, and where
 * @param arguments of its constructor
 * @param fixed flags of ports that always carry a message
 * @param before ports of the monitor, with the fields below the whole that have their messages
 *     before a step
 * @param after likewise, after a step
 * @param goesOn whether the program goes on after a violation
 */
public record WatchView(
        String type,
        String name,
        String comment,
        String arguments,
        List<String> fixed,
        List<AssignmentView> before,
        List<AssignmentView> after,
        boolean goesOn) {}
