package lejos.robotics;

/** Is told when a motor starts and stops; times in milliseconds since boot. */
public interface RegulatedMotorListener {
    void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp);

    void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp);
}
