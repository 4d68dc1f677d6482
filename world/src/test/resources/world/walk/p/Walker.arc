package p;

import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LightSensor;
import nxt.RegulatedMotor;

/** Goes on or back by the toss of a coin: whether the last reading was even. */
<<deploy>> component Walker {
    component LightSensor(SensorPort.S1) coin;
    component Legs legs;
    component RegulatedMotor(MotorPort.A) left;
    component RegulatedMotor(MotorPort.B) right;

    connect coin.value -> legs.light;
    connect legs.speed -> left.speed, right.speed;
}
