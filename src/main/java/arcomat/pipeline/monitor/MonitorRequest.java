package arcomat.pipeline.monitor;

/**
 * A class that is to watch a component.
 *
 * @param component as written; with {@code #automaton} for one requirement of several
 * @param out the folder to write, which is replaced as a whole
 */
public record MonitorRequest(String component, String out) {}
