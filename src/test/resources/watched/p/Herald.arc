package p;

import nxt.Brick.SensorPort;
import nxt.LcdLogger;
import nxt.TouchSensor;

/** Says what it meets. */
<<deploy>> component Herald {
    component TouchSensor(SensorPort.S1) bumper;
    component Crier crier;
    component LcdLogger(0) display;

    connect bumper.pressed -> crier.pressed;
    connect crier.text -> display.text;
}
