package coffee.fetcher;

import coffee.fig6.AvoidCrash;
import coffee.parts.Proximity;
import coffee.parts.Timer;
import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LightSensor;
import nxt.RegulatedMotor;
import nxt.TouchSensor;
import nxt.UltrasonicSensor;

/**
 * The coffee fetcher (the paper, Fig. 2): it follows a line with two light sensors, sees others
 * with an ultrasonic sensor and drives two motors. When two fetchers meet, the one with coffee
 * waits and the other makes room.
 *
 * Sensors on the left, logic in the middle, actuators on the right. One slice is one cycle of the
 * robot, 100 ms on the brick.
 */
<<deploy>> component Fetcher {
    // Sensors
    component UltrasonicSensor(SensorPort.S1) ultrasonic;
    component LightSensor(SensorPort.S2) left;
    component LightSensor(SensorPort.S3) right;
    component TouchSensor(SensorPort.S4) cup;

    // Logic
    component Proximity(25, 35) proximity;
    component LineStatusComp(45) line;
    component CupHolder cupHolder;
    component AvoidCrash avoidCrash;
    component Timer(2) timer;
    component Drive drive;

    // Actuators
    component RegulatedMotor(MotorPort.A) leftMotor;
    component RegulatedMotor(MotorPort.B) rightMotor;

    connect ultrasonic.distance -> proximity.distance;
    connect left.value -> line.leftLight;
    connect right.value -> line.rightLight;
    connect cup.pressed -> cupHolder.pressed;

    connect proximity.front -> avoidCrash.frontUS;
    connect line.ls -> avoidCrash.ls;
    connect cupHolder.gotCoffee -> avoidCrash.gotCoffee;
    connect avoidCrash.timerCmd -> timer.timerCmd;
    connect timer.timerSig -> avoidCrash.timerSig;

    connect avoidCrash.cmd -> drive.cmd;
    connect line.drift -> drive.drift;
    connect drive.leftSpeed -> leftMotor.speed;
    connect drive.rightSpeed -> rightMotor.speed;
}
