package ${packageName};

import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LcdLogger;
import nxt.RegulatedMotor;
import nxt.UltrasonicSensor;

/**
 * The robot: which part is plugged in where, and who talks to whom. <<deploy>> makes a program for the
 * brick of it.
 *
 * Try: a nxt.TouchSensor in front, and a pilot that listens to it.
 */
<<deploy>> component ${component} {
    component UltrasonicSensor(SensorPort.S1) eye;
    component ${component}Pilot pilot;
    component ${component}Wheels wheels;
    component RegulatedMotor(MotorPort.A) leftMotor;
    component RegulatedMotor(MotorPort.B) rightMotor;
    component LcdLogger(0) display;

    connect eye.distance -> pilot.distance;
    connect pilot.move -> wheels.move;
    connect wheels.left -> leftMotor.speed;
    connect wheels.right -> rightMotor.speed;
    connect wheels.doing -> display.text;
}
