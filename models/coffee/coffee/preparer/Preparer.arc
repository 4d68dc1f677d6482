package coffee.preparer;

import coffee.parts.Arm;
import coffee.parts.Brightness;
import coffee.parts.Timer;
import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LightSensor;
import nxt.RegulatedMotor;
import nxt.TouchSensor;

/**
 * The coffee preparer: a touch sensor feels the cup below the spout of an ordinary coffee
 * machine, a light sensor looks at the machine's lamp, and a motor moves the finger that presses
 * its button.
 */
<<deploy>> component Preparer {
    // Sensors
    component TouchSensor(SensorPort.S1) cup;
    component LightSensor(SensorPort.S2) lamp;

    // Logic
    component Brightness(60) brightness;
    component Brew brew;
    component Timer(3) timer;
    component Arm arm;

    // Actuators
    component RegulatedMotor(MotorPort.A) finger;

    connect cup.pressed -> brew.cup;
    connect lamp.value -> brightness.value;

    connect brightness.bright -> brew.ready;
    connect brew.timerCmd -> timer.timerCmd;
    connect timer.timerSig -> brew.timerSig;

    connect brew.finger -> arm.cmd;
    connect arm.speed -> finger.speed;
}
