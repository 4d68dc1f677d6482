package yard;

import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LcdLogger;
import nxt.RegulatedMotor;
import nxt.UltrasonicSensor;

/** Drives until something is near. */
<<deploy>> component Rover {
    component UltrasonicSensor(SensorPort.S1) eye;
    component RegulatedMotor(MotorPort.A) left;
    component RegulatedMotor(MotorPort.B) right;
    component LcdLogger(0) display;

    component Mind {
        timing instant;

        port <<total>> in Integer[0..255] distance, out Integer speed, out String doing;

        <<completion = "ignore">> automaton {
            state standing, driving;

            initial standing;

            standing -> driving [distance > 40] / {speed = 360, doing = "driving"};
            driving -> standing [distance <= 20] / {speed = 0, doing = "standing"};
        }
    }

    connect eye.distance -> mind.distance;
    connect mind.speed -> left.speed, right.speed;
    connect mind.doing -> display.text;
}
