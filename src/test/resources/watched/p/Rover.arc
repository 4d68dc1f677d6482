package p;

import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LcdLogger;
import nxt.RegulatedMotor;
import nxt.TouchSensor;

/** Stands while its bumper is pressed. What it logs is where violations are shown, too. */
<<deploy>> component Rover {
    component TouchSensor(SensorPort.S1) bumper;
    component Front front;
    component RegulatedMotor(MotorPort.A) wheel;
    component LcdLogger(6) log;

    connect bumper.pressed -> front.bumped;
    connect front.speed -> wheel.speed;
    connect front.doing -> log.text;
}
