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
 */
public record Kind(
        String name,
        Program program,
        double radius,
        double mass,
        Optional<Wheels> wheels,
        List<Device> devices) {
    /** How far a holder may be from where a cup drops or coffee runs, in mm. */
    private static final double TOLERANCE = 60;

    public Kind {
        devices = List.copyOf(devices);
    }

    /**
     * What runs on the brick.
     *
     * @param form how it is given
     * @param name path of a jar, or qualified name of a component
     * @param folder of the model root of a component; else empty. Paths are relative to the world's
     *     file
     * @param place where the world says so
     */
    public record Program(Form form, String name, String folder, Span place) {
        /** Ways to name a program. */
        public enum Form {
            JAR,
            COMPONENT
        }
    }

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
        for (Device device : devices) {
            if (type.isInstance(device)) {
                return Optional.of(type.cast(device));
            }
        }
        return Optional.empty();
    }
}
