package robots;

import nxt.*;
import nxt.Brick.*;
import robots.Talk.Order;

/** Sends a distance, an order and a key to the robot Bob. */
<<deploy>> component Caller {
    component UltrasonicSensor(SensorPort.S1) ultrasonic;
    component Button(Key.enter) enter;
    component BluetoothIn<Order>("Bob") answers;

    component Orders orders;
    component Words words;

    component BluetoothOut<Integer>("Bob") distances;
    component BluetoothOut<Order>("Bob", 1) commands;
    component BluetoothOut<Boolean>("Bob", 2) keys;
    component LcdLogger(0) answer;

    connect ultrasonic.distance -> distances.sent;
    connect enter.pressed -> orders.pressed, keys.sent;
    connect orders.order -> commands.sent;
    connect answers.received -> words.order;
    connect words.word -> answer.text;

    component Orders {
        timing instant;

        port in Boolean pressed, out Order order;

        table {
            in pressed;
            out order;
            | true  | => | go   |;
            | false | => | halt |;
        }
    }
}
