package yard;

import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LcdLogger;
import nxt.LcdNumber;
import nxt.LightSensor;
import nxt.RegulatedMotor;
import nxt.UltrasonicSensor;

/** Hurries, and counts farther than it may: then it stands and says so. */
<<deploy, cycle = "40">> component Rover {
    component UltrasonicSensor(SensorPort.S1) eye;
    component Mind mind;
    component Chassis chassis;
    component LcdNumber(0, "count") number;
    component LcdNumber(2) floor;
    component LcdLogger(1) display;

    connect eye.distance -> mind.distance;
    connect mind.speed -> chassis.speed;
    connect chassis.seen -> floor.number;
    connect mind.count -> number.number;
    connect mind.doing -> display.text;

    component Chassis {
        port in Integer speed, out Integer[0..100] seen;

        component RegulatedMotor(MotorPort.A) left;
        component LightSensor(SensorPort.S2) below;
        component RegulatedMotor(MotorPort.B) right;

        connect speed -> left.speed, right.speed;
        connect below.value -> seen;
    }

    component Mind {
        timing instant;

        port
            <<total>> in Integer[0..255] distance,
            out Integer speed,
            out Integer[-10..30] count,
            out String doing;

        Integer counted = -12;

        <<completion = "ignore">> automaton {
            state standing, driving;

            initial standing;

            standing -> driving [distance > 40] / {speed = 360, doing = "driving", counted = -10};
            driving {distance == ?} / {count = counted, counted = counted + 1};
        }
    }
}
