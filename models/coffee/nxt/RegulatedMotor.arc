package nxt;

import nxt.Brick.MotorPort;

/** A motor of the NXT with its speed regulated. It keeps its speed until the next message. */
<<platform, layer = "actuators">> component RegulatedMotor(MotorPort socket) {
    /** In degrees per second; negative turns backwards, 0 stops and holds. */
    port in Integer speed;
}
