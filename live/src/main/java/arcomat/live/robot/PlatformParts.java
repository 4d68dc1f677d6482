package arcomat.live.robot;

import arcomat.model.Component;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.network.Network.Device;
import arcomat.sim.device.Hardware;
import arcomat.sim.device.Key;
import arcomat.sim.device.SensorSocket;

import java.util.List;
import java.util.Set;

/** The platform components of package {@code nxt}, on one brick. */
final class PlatformParts {
    private static final Set<String> KNOWN =
            Set.of(
                    "nxt.BluetoothIn",
                    "nxt.BluetoothOut",
                    "nxt.Button",
                    "nxt.ColorSensor",
                    "nxt.DifferentialDrive",
                    "nxt.LcdLogger",
                    "nxt.LcdNumber",
                    "nxt.LightSensor",
                    "nxt.RegulatedMotor",
                    "nxt.SoundSensor",
                    "nxt.Speaker",
                    "nxt.Timer",
                    "nxt.TouchSensor",
                    "nxt.UltrasonicSensor");

    private final Hardware brick;
    private final Routine routine;
    private final Telephones telephones;

    PlatformParts(Hardware brick, Routine routine) {
        this.brick = brick;
        this.routine = routine;
        this.telephones = new Telephones(brick, routine);
    }

    /** Whether it is said here what a platform component does. */
    static boolean isKnown(Component component) {
        return KNOWN.contains(withoutTypes(component));
    }

    private static String withoutTypes(Component component) {
        return component.qualifiedName().replaceFirst("<.*", "");
    }

    /**
     * @param device of a known component
     */
    Part of(Device device) {
        List<Value> given = device.arguments();
        return switch (withoutTypes(device.component())) {
            case "nxt.BluetoothIn" ->
                    new Receiving(
                            routine,
                            telephones,
                            text(given.get(0)),
                            number(given.get(1)),
                            device.component().outputs().get(0).type());
            case "nxt.BluetoothOut" ->
                    new Sending(routine, telephones, text(given.get(0)), number(given.get(1)));
            case "nxt.Button" -> new Pressing(routine, brick, Key.values()[number(given.get(0))]);
            case "nxt.ColorSensor" -> new Hue(routine, socket(given), constants(device));
            case "nxt.DifferentialDrive" ->
                    new Driving(
                            routine,
                            shaft(given.get(0)),
                            shaft(given.get(1)),
                            number(given.get(2)),
                            number(given.get(3)));
            case "nxt.LcdLogger" -> new Telling(row(given));
            case "nxt.LcdNumber" -> new Counting(row(given), text(given.get(1)));
            case "nxt.LightSensor" ->
                    new Brightness(
                            routine, socket(given), number(given.get(1)), number(given.get(2)));
            case "nxt.RegulatedMotor" -> new Turning(shaft(given.get(0)));
            case "nxt.SoundSensor" -> new Loudness(routine, socket(given));
            case "nxt.Speaker" -> new Sounding(routine, brick, number(given.get(0)));
            case "nxt.Timer" ->
                    new Ticking(routine, brick, constants(device), number(given.get(0)));
            case "nxt.TouchSensor" -> new Touching(routine, socket(given));
            case "nxt.UltrasonicSensor" -> new Echo(routine, brick, socket(given));
            default -> throw new IllegalArgumentException(device.component().qualifiedName());
        };
    }

    private static Type.EnumType constants(Device device) {
        return (Type.EnumType) device.component().outputs().get(0).type();
    }

    private SensorSocket socket(List<Value> given) {
        return brick.socket(number(given.get(0)));
    }

    private Shaft shaft(Value socket) {
        return new Shaft(routine, brick.motor(number(socket)));
    }

    private Lettering row(List<Value> given) {
        return new Lettering(routine, brick, number(given.get(0)));
    }

    /** A number as it is, a constant by its place. */
    private static int number(Value value) {
        return value instanceof Value.EnumValue constant ? constant.ordinal() : (int) value.whole();
    }

    private static String text(Value value) {
        return ((Value.StringValue) value).value();
    }
}
