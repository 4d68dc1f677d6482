package arcomat.generate.view;

import arcomat.generate.language.TypeName;
import arcomat.generate.view.HeadView.AssignmentView;

import java.util.List;

/**
 * A main program; {@code head} is that of the component that it runs, {@code name} its own.
 *
 * @param events whether events wait for it; else it works slice by slice
 * @param call what it does in a slice; empty where that is nothing
 * @param cycle length of a slice in milliseconds
 * @param watches what it watches itself for
 */
public record ProgramView(
        HeadView head,
        TypeName self,
        boolean senses,
        boolean events,
        String call,
        String cycle,
        List<WatchView> watches) {
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
}
