package coffee.floor;

import coffee.floor.Orders.*;
import coffee.parts.Arm;
import coffee.parts.Brightness;
import coffee.parts.Timer;
import nxt.BluetoothOut;
import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LightSensor;
import nxt.RegulatedMotor;
import nxt.TouchSensor;

/**
 * The coffee preparer, with a word for the fetcher: coffee.preparer.Preparer cannot keep it below
 * the spout.
 */
<<deploy>> component Barista {
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
    component BluetoothOut<Order>("courier") fetcher;

    connect cup.pressed -> brew.cup;
    connect lamp.value -> brightness.value;

    connect brightness.bright -> brew.ready;
    connect brew.timerCmd -> timer.timerCmd;
    connect timer.timerSig -> brew.timerSig;
    connect brew.order -> fetcher.sent;

    connect brew.finger -> arm.cmd;
    connect arm.speed -> finger.speed;
}
