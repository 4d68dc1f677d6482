package arcomat.sim;

import arcomat.sim.trace.Event;
import arcomat.sim.trace.Trace;

import java.util.stream.Collectors;

/** Traces as lines of text. */
final class TraceText {
    private static final long MILLISECOND = 1000;

    private TraceText() {}

    static String of(Trace trace) {
        return trace.events().stream()
                .map(event -> event.time() / MILLISECOND + " " + text(event) + "\n")
                .collect(Collectors.joining());
    }

    private static String text(Event event) {
        if (event instanceof Event.SensorRead read) {
            return read.socket() + " " + read.value();
        } else if (event instanceof Event.MotorOrdered ordered) {
            return ordered.motor() + " " + ordered.order() + " " + ordered.value();
        } else if (event instanceof Event.ScreenChanged changed) {
            return "screen " + String.join("|", changed.rows()).replaceAll("\\|+$", "");
        } else if (event instanceof Event.TonePlayed tone) {
            return "tone " + tone.hertz() + " " + tone.milliseconds();
        } else if (event instanceof Event.PacketSent sent) {
            return "sent " + sent.bytes();
        } else if (event instanceof Event.PacketReceived received) {
            return "received " + received.bytes();
        }
        throw new AssertionError(event);
    }
}
