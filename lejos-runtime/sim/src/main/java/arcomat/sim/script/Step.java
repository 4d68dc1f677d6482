package arcomat.sim.script;

/**
 * An action and its moment.
 *
 * @param time milliseconds since the brick was switched on
 */
public record Step(long time, Action action) {}
