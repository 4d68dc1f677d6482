package arcomat.sim;

import arcomat.sim.device.MotorOrder;

/**
 * A motor at a moment.
 *
 * @param order what it was last told
 * @param value the number that goes with the order
 * @param speed in degrees per second, as it turns now
 * @param tachoCount in degrees, since the program last reset it
 */
public record MotorState(MotorOrder order, int value, double speed, int tachoCount) {}
