package lejos.robotics;

/** An unregulated motor that counts degrees. */
public interface EncoderMotor extends DCMotor, Encoder {}
