package arcomat.generate.view;

/**
 * A main program; {@code head} is that of the component that it runs, {@code name} its own.
 *
 * @param cycle length of a slice in milliseconds
 */
public record ProgramView(
        HeadView head,
        String packageName,
        String prefix,
        String folder,
        String name,
        boolean senses,
        boolean events,
        String cycle) {}
