package coffee.floor;

import coffee.fetcher.CupHolder;
import coffee.fetcher.LineStatusComp;
import coffee.floor.Orders.*;
import coffee.parts.Proximity;
import coffee.parts.Timer;
import nxt.BluetoothIn;
import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LcdLogger;
import nxt.LightSensor;
import nxt.RegulatedMotor;
import nxt.TouchSensor;
import nxt.UltrasonicSensor;

/**
 * The coffee fetcher as it drives on a real floor: coffee.fetcher.Fetcher with parts that were
 * refined until they mastered the worlds of folder world. It looks longer before it moves, makes
 * room by a manoeuvre, finds its line again, stands when the robot that fills its cup says so, and
 * shows what it is doing.
 */
<<deploy>> component Courier {
    // Sensors
    component UltrasonicSensor(SensorPort.S1) ultrasonic;
    component LightSensor(SensorPort.S2) left;
    component LightSensor(SensorPort.S3) right;
    component TouchSensor(SensorPort.S4) cup;
    component BluetoothIn<Order>("") station;

    // Logic
    component Proximity(25, 35) proximity;
    component Calm calm;
    component LineStatusComp(45) line;
    component CupHolder cupHolder;
    component AvoidCrash avoidCrash;
    component Timer(80) timer;
    component Halt halt;
    component Drive drive;

    // Actuators
    component RegulatedMotor(MotorPort.A) leftMotor;
    component RegulatedMotor(MotorPort.B) rightMotor;
    component LcdLogger(0) display;

    connect ultrasonic.distance -> proximity.distance;
    connect left.value -> line.leftLight;
    connect right.value -> line.rightLight;
    connect cup.pressed -> cupHolder.pressed;

    connect proximity.front -> calm.seen;
    connect calm.front -> avoidCrash.frontUS;
    connect line.ls -> avoidCrash.ls, drive.ls;
    connect line.drift -> drive.drift;
    connect cupHolder.gotCoffee -> avoidCrash.gotCoffee;
    connect avoidCrash.timerCmd -> timer.timerCmd;
    connect timer.timerSig -> avoidCrash.timerSig;

    connect avoidCrash.cmd -> halt.wanted;
    connect station.received -> halt.order;
    connect halt.cmd -> drive.cmd;

    connect drive.leftSpeed -> leftMotor.speed;
    connect drive.rightSpeed -> rightMotor.speed;
    connect avoidCrash.doing -> display.text;
}
