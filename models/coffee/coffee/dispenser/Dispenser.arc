package coffee.dispenser;

import coffee.parts.Arm;
import coffee.parts.Proximity;
import coffee.parts.Timer;
import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.RegulatedMotor;
import nxt.TouchSensor;
import nxt.UltrasonicSensor;

/**
 * The cup dispenser: an ultrasonic sensor looks down the chute for a fetcher, a touch sensor
 * feels the stack of cups, and a motor moves the slide that pushes one cup out.
 */
<<deploy>> component Dispenser {
    // Sensors
    component UltrasonicSensor(SensorPort.S1) ultrasonic;
    component TouchSensor(SensorPort.S2) magazine;

    // Logic
    component Proximity(10, 20) proximity;
    component DropCup dropCup;
    component Timer(3) timer;
    component Arm arm;

    // Actuators
    component RegulatedMotor(MotorPort.A) slide;

    connect ultrasonic.distance -> proximity.distance;
    connect magazine.pressed -> dropCup.cups;

    connect proximity.front -> dropCup.below;
    connect dropCup.timerCmd -> timer.timerCmd;
    connect timer.timerSig -> dropCup.timerSig;

    connect dropCup.slide -> arm.cmd;
    connect arm.speed -> slide.speed;
}
