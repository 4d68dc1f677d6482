package robots;

import nxt.*;
import nxt.Brick.*;

/** Sensors whose readings are seen on motors and display. */
<<deploy>> component Devices {
    component UltrasonicSensor(SensorPort.S1) ultrasonic;
    component LightSensor(SensorPort.S2, 300, 600) light;
    component SoundSensor(SensorPort.S3) sound;
    component ColorSensor(SensorPort.S4) colour;
    component Button(Key.left) left;
    component Timer(1000) second;

    component Reading reading;

    component RegulatedMotor(MotorPort.C) arm;
    component DifferentialDrive(MotorPort.A, MotorPort.B) drive;
    component LcdNumber(0, "distance") distance;
    component LcdNumber(1) brightness;
    component LcdLogger(2) seen;
    component Speaker(500) speaker;

    connect ultrasonic.distance -> distance.number;
    connect light.value -> brightness.number;
    connect sound.level -> drive.speed;
    connect reading.turn -> drive.turn;
    connect colour.color -> reading.color;
    connect left.pressed -> reading.pressed;
    connect second.signal -> reading.second;
    connect reading.speed -> arm.speed;
    connect reading.name -> seen.text;
    connect reading.frequency -> speaker.frequency;

    component Reading {
        timing instant;

        port
            <<total>> in Color color,
            <<total>> in Boolean pressed,
            in Tick second,
            out Integer[-1000..1000] turn,
            out Integer speed,
            out String name,
            out Integer[31..14080] frequency;

        <<completion = "ignore">> automaton {
            state up, down;

            initial up;

            up -> down {color == red, pressed == true} / {name = "red", speed = 90, turn = 90};
            up -> down {color == none, pressed == true} / {name = "none", speed = -90, turn = 0};
            down -> up {pressed == false} / {speed = 0, turn = -45};
            up {pressed == false, second == tick} / {frequency = 440};
        }
    }
}
