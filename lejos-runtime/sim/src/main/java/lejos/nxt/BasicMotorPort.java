package lejos.nxt;

/** A socket for a motor, without a tachometer. */
public interface BasicMotorPort {
    int PWM_FLOAT = 0;
    int PWM_BRAKE = 1;
    int FORWARD = 1;
    int BACKWARD = 2;
    int STOP = 3;
    int FLOAT = 4;
    int MAX_POWER = 100;

    void controlMotor(int power, int mode);

    void setPWMMode(int mode);
}
