package robots;

import nxt.*;
import nxt.Brick.*;
import robots.Talk.Order;

/** One of each platform component of the library. */
<<deploy>> component Everything {
    component UltrasonicSensor(SensorPort.S1) ultrasonic;
    component LightSensor(SensorPort.S2, 300, 600) light;
    component SoundSensor(SensorPort.S3) sound;
    component ColorSensor(SensorPort.S4) colour;
    component Button(Key.left) left;
    component Timer(1000) second;
    component BluetoothIn<Order>("Alice") orders;
    component BluetoothIn<Integer>("Alice", 1) numbers;
    component BluetoothIn<Boolean>("", 2) flags;

    component Chooser chooser;

    component RegulatedMotor(MotorPort.C) arm;
    component DifferentialDrive(MotorPort.A, MotorPort.B) drive;
    component LcdNumber(0, "distance") distance;
    component LcdLogger(1) log;
    component Speaker(500) speaker;
    component BluetoothOut<Order>("Alice") echo;
    component BluetoothOut<Color>("Alice", 1) colours;
    component BluetoothOut<Integer>("Bob") values;
    component BluetoothOut<Boolean>("Bob", 1) presses;

    connect ultrasonic.distance -> distance.number;
    connect light.value -> drive.speed, values.sent;
    connect sound.level -> drive.turn;
    connect colour.color -> colours.sent;
    connect left.pressed -> presses.sent;
    connect second.signal -> chooser.second;
    connect orders.received -> echo.sent, chooser.order;
    connect numbers.received -> arm.speed;
    connect flags.received -> chooser.flag;
    connect chooser.text -> log.text;
    connect chooser.frequency -> speaker.frequency;

    component Chooser {
        timing instant;

        port
            in Tick second,
            in Order order,
            in Boolean flag,
            out String text,
            out Integer[31..14080] frequency;

        <<completion = "ignore">> automaton {
            state on;

            initial on;

            on {order == go} / {text = "go", frequency = 440};
            on {order == halt} / {text = "halt", frequency = 220};
            on {order == --, flag == true} / {text = "flag"};
            on {order == --, flag == --, second == ?} / {text = "tick"};
        }
    }
}
