package shop;

import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.RegulatedMotor;
import nxt.TouchSensor;

/** A robot with a bumper and a wheel. */
<<deploy>> component Rover {
    component TouchSensor(SensorPort.S1) touch;
    component Bumper bumper;
    component Gear gear;
    component RegulatedMotor(MotorPort.A) motor;

    connect touch.pressed -> bumper.wall;
    connect bumper.wheels -> gear.command;
    connect gear.speed -> motor.speed;
}
