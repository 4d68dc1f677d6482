package nxt;

import nxt.Brick.MotorPort;

/**
 * Two driven wheels beside each other. Speed and turn add up, and each keeps its value until the
 * next message on its port. It stands still before the first and after the program.
 *
 * diameter: of a wheel, in mm
 * track: from the middle of one wheel to the middle of the other, in mm
 */
<<platform, layer = "actuators">> component DifferentialDrive(MotorPort left, MotorPort right,
        Integer[1..1000] diameter = 56, Integer[1..1000] track = 112) {
    port
        /** Of the robot's middle, in mm per second; negative drives backwards. */
        in Integer[-1000..1000] speed,
        /** In degrees per second; positive turns to the left. */
        in Integer[-1000..1000] turn;
}
