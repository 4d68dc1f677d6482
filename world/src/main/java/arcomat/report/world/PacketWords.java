package arcomat.report.world;

import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.RobotRun;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What packets between robots mean, as far as models say it: the model library sends a channel and
 * a number of four bytes, and the model of who sends knows which constant that number is.
 */
public final class PacketWords {
    private static final String LIBRARY = "nxt";
    private static final String SENDER = "BluetoothOut";
    private static final int DIGITS = 10;
    private static final int HEXADECIMAL = 16;

    /** What a robot sends on a channel. */
    private record Line(String robot, long channel) {}

    private final Map<Line, Type> types = new HashMap<>();

    private PacketWords() {}

    /** Of robots whose models are known. */
    public static PacketWords of(List<RobotRun> inside) {
        PacketWords words = new PacketWords();
        inside.forEach(each -> words.learn(each.robot(), each.trace()));
        return words;
    }

    private void learn(String robot, Trace trace) {
        for (Network.Device device : Network.of(trace.component(), List.of()).devices()) {
            Component sender = device.component();
            if (sender.packageName().equals(LIBRARY)
                    && sender.name().startsWith(SENDER)
                    && device.arguments().size() > 1
                    && device.arguments().get(1) instanceof Value.IntegerValue channel) {
                types.put(new Line(robot, channel.value()), sender.inputs().get(0).type());
            }
        }
    }

    /**
     * A packet in words; empty where its sender's model does not say what it is.
     *
     * @param bytes in hexadecimal
     */
    public Optional<String> of(String robot, String bytes) {
        if (bytes.length() != DIGITS) {
            return Optional.empty();
        }
        long channel = Long.parseLong(bytes.substring(0, 2), HEXADECIMAL);
        int number = (int) Long.parseLong(bytes.substring(2), HEXADECIMAL);
        Type type = types.get(new Line(robot, channel));
        // Generated enums count from one.
        return type instanceof Type.EnumType constants
                        && number > 0
                        && number <= constants.constants().size()
                ? Optional.of(constants.constants().get(number - 1))
                : Optional.empty();
    }
}
