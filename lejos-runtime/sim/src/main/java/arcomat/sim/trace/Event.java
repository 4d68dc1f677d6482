package arcomat.sim.trace;

import arcomat.sim.device.MotorName;
import arcomat.sim.device.MotorOrder;
import arcomat.sim.device.SensorName;

import java.util.List;
import java.util.stream.Collectors;

/** Something that a program did. Times are microseconds since the brick was switched on. */
public sealed interface Event {
    long time();

    /** What a table of sensors and motors does not show of it, in words; else empty. */
    String besides();

    /** A sensor was read and gave this value, in the unit of the method that read it. */
    record SensorRead(long time, SensorName socket, int value) implements Event {
        @Override
        public String besides() {
            return "";
        }
    }

    /** A motor was told something new. */
    record MotorOrdered(long time, MotorName motor, MotorOrder order, int value) implements Event {
        @Override
        public String besides() {
            return "";
        }
    }

    /** The screen shows other rows. */
    record ScreenChanged(long time, List<String> rows) implements Event {
        public ScreenChanged {
            rows = List.copyOf(rows);
        }

        @Override
        public String besides() {
            return "screen: "
                    + rows.stream()
                            .filter(row -> !row.isBlank())
                            .collect(Collectors.joining(" | "));
        }
    }

    /** A tone began. */
    record TonePlayed(long time, int hertz, int milliseconds) implements Event {
        @Override
        public String besides() {
            return "tone: " + hertz + " Hz, " + milliseconds + " ms";
        }
    }

    /** A packet went out over Bluetooth; its bytes in hexadecimal. */
    record PacketSent(long time, String bytes) implements Event {
        @Override
        public String besides() {
            return "sent: " + bytes;
        }
    }

    /** A packet, or a part of one, was read from Bluetooth; its bytes in hexadecimal. */
    record PacketReceived(long time, String bytes) implements Event {
        @Override
        public String besides() {
            return "received: " + bytes;
        }
    }
}
