package arcomat.world;

import arcomat.world.Kind.Described;
import arcomat.world.Kind.Program;
import arcomat.world.Kind.Wheels;
import arcomat.world.Words.Unreadable;
import arcomat.world.arithmetic.Circle;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A kind of robots while it is read: the lines below {@code kind NAME}, one part each. */
final class KindDraft {
    static final String TWICE = "ARC1126";

    /** What a line of a kind may begin with. */
    static final List<String> PARTS =
            List.of(
                    "program",
                    "body",
                    "wheels",
                    "ultrasonic",
                    "light",
                    "bumper",
                    "holder",
                    "chute",
                    "magazine",
                    "feeler",
                    "lamp",
                    "slide",
                    "finger",
                    "device");

    private static final List<String> SOCKETS = List.of("S1", "S2", "S3", "S4");
    private static final List<String> MOTORS = List.of("A", "B", "C");
    private static final double FAR = 1000;

    private final Word name;
    private final List<Device> devices = new ArrayList<>();
    private final List<Described> described = new ArrayList<>();
    private final Map<String, Word> used = new LinkedHashMap<>();
    private @Nullable Program program;
    private double radius = 80;
    private double mass = 900;
    private @Nullable Wheels wheels;

    KindDraft(Word name) {
        this.name = name;
    }

    Word name() {
        return name;
    }

    /** The kind, if it says what its program is. */
    Optional<Kind> kind() {
        return Optional.ofNullable(program)
                .map(
                        p ->
                                new Kind(
                                        name.text(),
                                        p,
                                        radius,
                                        mass,
                                        Optional.ofNullable(wheels),
                                        devices,
                                        described));
    }

    /** Reads a line that begins with one of {@link #PARTS}. */
    void read(Words words) throws Unreadable {
        Word part = words.next("a part");
        switch (part.text()) {
            case "program" -> {
                once(part);
                program = program(words);
            }
            case "body" -> {
                once(part);
                radius = radius(words);
                mass = mass(words);
            }
            case "wheels" -> {
                once(part);
                wheels = wheels(words);
            }
            case "device" -> described.add(described(words));
            case "slide", "finger" -> devices.add(arm(part, words));
            default -> devices.add(sensor(part.text(), socket(words), words));
        }
        words.end();
    }

    /** Of a body. */
    static double radius(Words words) throws Unreadable {
        return words.number("its radius in mm", 10, 500);
    }

    /** Of a body. */
    static double mass(Words words) throws Unreadable {
        return words.number("its mass in grams", 50, 20_000);
    }

    /** The socket may have a sensor, too: it says what is around the device. */
    private Described described(Words words) throws Unreadable {
        Word socket = words.choice("a socket", SOCKETS);
        once(socket, "device in ");
        Word device = words.next("the path of a Java file");
        return new Described(SOCKETS.indexOf(socket.text()) + 1, device);
    }

    private void once(Word word) throws Unreadable {
        once(word, "");
    }

    /**
     * @param use what the word is used for, where it may also be used for something else
     */
    private void once(Word word, String use) throws Unreadable {
        Word before = used.putIfAbsent(use + word.text(), word);
        if (before != null) {
            throw new Unreadable(
                    word.error(
                                    TWICE,
                                    "kind '%s' has '%s' twice"
                                            .formatted(name.text(), use + word.text()))
                            .withRelated(before.place(), "the first one"));
        }
    }

    private static Program program(Words words) throws Unreadable {
        if (words.choice("what it is given as", List.of("component", "jar")).text().equals("jar")) {
            Word file = words.next("the path of a jar");
            return new Program(Program.Form.JAR, file, Optional.empty());
        }
        Word component = words.call("the qualified name of a component");
        words.expect("in");
        Word folder = words.next("the folder of its models");
        return new Program(Program.Form.COMPONENT, component, Optional.of(folder));
    }

    private Wheels wheels(Words words) throws Unreadable {
        int left = motor(words);
        int right = motor(words);
        double diameter = words.take("diameter") ? words.number("mm", 5, 500) : 56;
        double track = words.take("track") ? words.number("mm", 10, 1000) : 112;
        return new Wheels(left, right, diameter, track);
    }

    /** The state of a robot has room for one. */
    private Device arm(Word part, Words words) throws Unreadable {
        if (devices.stream()
                .anyMatch(d -> d instanceof Device.Slide || d instanceof Device.Finger)) {
            throw new Unreadable(part.error(TWICE, "a robot has one arm, a slide or a finger"));
        }
        int motor = motor(words);
        if (part.text().equals("slide")) {
            return new Device.Slide(motor);
        }
        words.expect("brews");
        return new Device.Finger(motor, words.number("the seconds for a cup", 0.1, 600));
    }

    private Device.Sensor sensor(String type, int socket, Words words) throws Unreadable {
        return switch (type) {
            case "ultrasonic" -> new Device.Ultrasonic(socket, place(words), facing(words));
            case "light" -> new Device.Light(socket, place(words));
            case "holder" -> new Device.Holder(socket, place(words));
            case "chute" -> new Device.Chute(socket, place(words));
            case "feeler" -> new Device.Feeler(socket, place(words));
            case "magazine" -> {
                words.expect("cups");
                yield new Device.Magazine(socket, words.count("how many", 0, 10_000));
            }
            case "lamp" -> new Device.Lamp(socket);
            default -> new Device.Bumper(socket);
        };
    }

    /** In mm from the robot's middle; the middle where nothing is said. */
    private static Point place(Words words) throws Unreadable {
        if (!words.take("at")) {
            return new Point(0, 0);
        }
        return new Point(
                words.number("mm to its front", -FAR, FAR),
                words.number("mm to its left", -FAR, FAR));
    }

    private static double facing(Words words) throws Unreadable {
        return words.take("facing")
                ? Circle.radians(words.number("degrees to its left", -360, 360))
                : 0;
    }

    private int socket(Words words) throws Unreadable {
        return connection(words, "a socket", SOCKETS);
    }

    private int motor(Words words) throws Unreadable {
        return connection(words, "a motor", MOTORS);
    }

    /** Counts from 1. */
    private int connection(Words words, String meaning, List<String> names) throws Unreadable {
        Word word = words.choice(meaning, names);
        once(word);
        return names.indexOf(word.text()) + 1;
    }
}
