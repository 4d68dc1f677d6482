package arcomat.analysis.automaton;

/**
 * A component whose automata cannot be examined as they stand.
 *
 * @param reason what is missing, and what to do
 */
public record Unexamined(String component, String reason) {}
