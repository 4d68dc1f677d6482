package arcomat.generate.view;

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
        String packageName,
        String prefix,
        String folder,
        String name,
        boolean senses,
        boolean events,
        String call,
        String cycle,
        List<WatchView> watches) {}
