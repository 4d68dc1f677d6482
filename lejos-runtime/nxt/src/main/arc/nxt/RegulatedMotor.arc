package nxt;

import nxt.Brick.MotorPort;

/**
 * A motor with its speed regulated. It keeps its speed until the next message, and stands still
 * before the first and after the program.
 */
<<platform, layer = "actuators">> component RegulatedMotor(MotorPort socket) {
    /**
     * In degrees per second; negative turns backwards, 0 stops and holds. A motor reaches about
     * 100 times the volts of the battery, 700 to 900; above that it turns as fast as it can.
     */
    port in Integer speed;
}
