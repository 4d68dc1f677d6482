package sprint;

import nxt.Brick.MotorPort;
import nxt.Brick.SensorPort;
import nxt.LcdLogger;
import nxt.LightSensor;
import nxt.RegulatedMotor;

/**
 * Follows a dark line as fast as it is told. How fast that may be depends on how wide the line is:
 * what has crossed it between two looks is gone.
 *
 * cruise: of both wheels on the line, in degrees per second
 */
component LineRunner(Integer[0..900] cruise) {
    component LightSensor(SensorPort.S2) leftEye;
    component LightSensor(SensorPort.S3) rightEye;
    component Steering(cruise) steering;
    component RegulatedMotor(MotorPort.A) leftMotor;
    component RegulatedMotor(MotorPort.B) rightMotor;
    component LcdLogger(0) display;

    /** Turns to the side that has seen the line last. */
    component Steering(Integer cruise) {
        timing instant;

        port
            /** In percent: the line has 15, the floor 75. */
            <<total>> in Integer[0..100] left,
            <<total>> in Integer[0..100] right,
            /** In degrees per second. */
            out Integer leftSpeed,
            out Integer rightSpeed,
            out String doing;

        automaton {
            state standing, straight, turningLeft, turningRight;

            initial standing;

            standing -> straight / {leftSpeed = cruise, rightSpeed = cruise, doing = "straight"};

            straight [left < 45 && right < 45];
            straight [left >= 45 && right >= 45];
            straight -> turningLeft [left < 45 && right >= 45]
                    / {leftSpeed = cruise / 4, rightSpeed = cruise, doing = "left"};
            straight -> turningRight [left >= 45 && right < 45]
                    / {leftSpeed = cruise, rightSpeed = cruise / 4, doing = "right"};

            turningLeft -> straight [left < 45 && right < 45]
                    / {leftSpeed = cruise, rightSpeed = cruise, doing = "straight"};
            turningLeft -> turningRight [left >= 45 && right < 45]
                    / {leftSpeed = cruise, rightSpeed = cruise / 4, doing = "right"};
            turningLeft [right >= 45];

            turningRight -> straight [left < 45 && right < 45]
                    / {leftSpeed = cruise, rightSpeed = cruise, doing = "straight"};
            turningRight -> turningLeft [left < 45 && right >= 45]
                    / {leftSpeed = cruise / 4, rightSpeed = cruise, doing = "left"};
            turningRight [left >= 45];
        }
    }

    connect leftEye.value -> steering.left;
    connect rightEye.value -> steering.right;
    connect steering.leftSpeed -> leftMotor.speed;
    connect steering.rightSpeed -> rightMotor.speed;
    connect steering.doing -> display.text;
}
