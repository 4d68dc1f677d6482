package robots;

import nxt.*;
import robots.Talk.Order;

/** Shows what the robot that calls it says, and sends its orders back. */
<<deploy>> component Answerer {
    component BluetoothIn<Integer>("") distances;
    component BluetoothIn<Order>("", 1) commands;
    component BluetoothIn<Boolean>("", 2) keys;

    component Words words;
    component Light light;

    component LcdNumber(0) distance;
    component LcdLogger(1) command;
    component LcdLogger(2) key;
    component BluetoothOut<Order>("") answers;

    connect distances.received -> distance.number;
    connect commands.received -> words.order, answers.sent;
    connect words.word -> command.text;
    connect keys.received -> light.pressed;
    connect light.word -> key.text;

    component Light {
        timing instant;

        port in Boolean pressed, out String word;

        table {
            in pressed;
            out word;
            | true  | => | "pressed"  |;
            | false | => | "released" |;
            | --    | => | --         |;
        }
    }
}
