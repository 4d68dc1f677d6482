package arcomat.world;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/**
 * How some robots are built.
 *
 * @param radius of the body, in mm
 * @param mass in grams; a heavy robot takes longer to take up the speed of its wheels
 * @param wheels absent from a robot that stands
 * @param described sensors that answer as a file of the team says
 */
public record Kind(
        String name,
        Program program,
        double radius,
        double mass,
        Optional<Wheels> wheels,
        List<Device> devices,
        List<Described> described) {
    /** How far a holder may be from where a cup drops or coffee runs, in mm. */
    private static final double TOLERANCE = 60;

    public Kind {
        devices = List.copyOf(devices);
        described = List.copyOf(described);
    }

    /**
     * Two driven wheels.
     *
     * @param left motor, 1 to 3
     * @param right motor, 1 to 3
     * @param diameter in mm
     * @param track from wheel to wheel, in mm
     */
    public record Wheels(int left, int right, double diameter, double track) {
        /** How far a wheel rolls for one degree, in mm. */
        double roll() {
            return Math.PI * diameter / 360;
        }
    }

    /**
     * What runs on the brick.
     *
     * @param form how it is given
     * @param name path of a jar, or qualified name of a component, with arguments if it takes some
     * @param folder of the model root of a component; else empty. Paths are relative to the world's
     *     file
     * @param place where the world says so
     */
    public record Program(Form form, String name, String folder, Span place) {
        /** What tells it from every other program, wherever it is named. */
        public String key() {
            return form + " " + name + " in " + folder;
        }

        /** Ways to name a program. */
        public enum Form {
            JAR,
            COMPONENT
        }
    }

    /**
     * A sensor that a program asks over two wires.
     *
     * @param socket 1 to 4; the sensor that the kind has there says what is around it
     * @param device a file that describes it, relative to the world's file, or a kind of sensors
     * @param place where the world says so
     */
    public record Described(int socket, String device, Span place) {}

    /** What a robot of this kind fills at a place. */
    Disc body(Pose pose) {
        return new Disc(pose.point(), radius);
    }

    /** Its sensors, in the order of the text. */
    public List<Device.Sensor> sensors() {
        return devices.stream()
                .filter(Device.Sensor.class::isInstance)
                .map(Device.Sensor.class::cast)
                .toList();
    }

    /** Whether a cup at a place would be in its holder, or above that. */
    boolean holdsAt(Pose pose, Point place) {
        return find(Device.Holder.class)
                .map(holder -> pose.place(holder.place()).distance(place))
                .filter(distance -> distance <= TOLERANCE)
                .isPresent();
    }

    /** The device of a type, if the robot has one. */
    <D extends Device> Optional<D> find(Class<D> type) {
        return devices.stream().filter(type::isInstance).map(type::cast).findFirst();
    }
}
