package lejos.nxt;

import lejos.robotics.Encoder;

/** A socket for a motor with a tachometer. */
public interface TachoMotorPort extends BasicMotorPort, Encoder {}
