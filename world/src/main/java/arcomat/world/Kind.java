package arcomat.world;

import arcomat.source.Diagnostic;

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

        /**
         * Whether neither turns.
         *
         * @param shafts speeds of motors
         */
        boolean stand(double[] shafts) {
            return shafts[left - 1] == 0 && shafts[right - 1] == 0;
        }
    }

    /**
     * What runs on the brick.
     *
     * @param form how it is given
     * @param named path of a jar, or qualified name of a component, with arguments if it takes some
     * @param models the model root of a component; absent for a jar. Paths are relative to the
     *     world's file
     */
    public record Program(Form form, Word named, Optional<Word> models) {
        /** The path or the qualified name. */
        public String name() {
            return named.text();
        }

        /** Of the model root of a component; else empty. */
        public String folder() {
            return models.map(Word::text).orElse("");
        }

        /** A finding about it, with the values of the parameters by which the world names it. */
        public Diagnostic error(String code, String message) {
            return models.map(named::toldWith).orElse(named).error(code, message);
        }

        /** What tells it from every other program, wherever it is named. */
        public String key() {
            return form + " " + name() + " in " + folder();
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
     * @param named a file that describes it, relative to the world's file, or a kind of sensors
     */
    public record Described(int socket, Word named) {
        /** The file or the kind. */
        public String device() {
            return named.text();
        }

        /** Whether it is described by a program: code of somebody's, to be run on the PC. */
        public boolean isProgram() {
            return device().endsWith(".java");
        }

        /** A finding about it, with the values of the parameters by which the world names it. */
        public Diagnostic error(String code, String message) {
            return named.error(code, message);
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
        return devices.stream().filter(type::isInstance).map(type::cast).findFirst();
    }
}
