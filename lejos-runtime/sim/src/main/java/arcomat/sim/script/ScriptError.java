package arcomat.sim.script;

/**
 * Something in a script that cannot be read.
 *
 * @param line from 1
 * @param column from 1
 * @param length how many characters are meant, at least 1
 * @param message what is wrong and what would be right
 */
public record ScriptError(int line, int column, int length, String message) {}
