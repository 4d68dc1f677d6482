package p;

import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LcdLogger;
import nxt.RegulatedMotor;
import nxt.TouchSensor;
import nxt.UltrasonicSensor;

/** Drives on, in a bend whenever its eye sees something near; says when its bumper is pressed. */
<<deploy>> component Plough {
    component UltrasonicSensor(SensorPort.S1) eye;
    component TouchSensor(SensorPort.S2) bumper;
    component RegulatedMotor(MotorPort.A) left;
    component RegulatedMotor(MotorPort.B) right;
    component LcdLogger(0) display;

    component Bend {
        timing instant;
        port <<total>> in Integer[0..255] distance, out Integer leftSpeed, out Integer rightSpeed;

        <<completion = "ignore">> automaton {
            state standing, straight, bent;

            initial standing;

            standing -> straight / {leftSpeed = 540, rightSpeed = 540};
            straight -> bent [distance % 3 == 0] / {rightSpeed = 500};
            bent -> straight [distance % 3 == 1] / {rightSpeed = 540};
        }
    }

    component Feel {
        timing instant;
        port <<total>> in Boolean pressed, out String doing;

        <<completion = "ignore">> automaton {
            state free, pushing;

            initial free;

            free -> pushing [pressed] / {doing = "pushing"};
            pushing -> free [!pressed] / {doing = "free"};
        }
    }

    connect eye.distance -> bend.distance;
    connect bend.leftSpeed -> left.speed;
    connect bend.rightSpeed -> right.speed;
    connect bumper.pressed -> feel.pressed;
    connect feel.doing -> display.text;
}
