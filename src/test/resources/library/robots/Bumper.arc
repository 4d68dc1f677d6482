package robots;

import nxt.BluetoothOut;
import nxt.Brick.SensorPort;
import nxt.TouchSensor;

/** Tells another robot when it hits something: what Everything has no socket left for. */
<<deploy>> component Bumper {
    component TouchSensor(SensorPort.S1) front;
    component BluetoothOut<Boolean>("", 2) hit;

    connect front.pressed -> hit.sent;
}
