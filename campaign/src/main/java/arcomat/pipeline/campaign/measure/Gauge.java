package arcomat.pipeline.campaign.measure;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.pipeline.world.Witness.Instruments;
import arcomat.world.Device;
import arcomat.world.Scene;
import arcomat.world.World;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;

/** Reads one thing of a world at a moment. */
interface Gauge {
    /** Of the world as a whole. */
    String TIME = "time";

    String DELIVERED = "delivered";

    /** Of a robot. */
    String DISPLAY = "display";

    String CUP = "cup";
    String SOCKET = "S";

    /** Of a drinker. */
    String PRESENT = "present";

    String CUPS = "cups";

    /** Of a thing, in mm. */
    String X = "x";

    String Y = "y";

    double MILLISECONDS = 1000;

    /** Null where there is nothing to read. */
    @Nullable Value read(Scene scene, Instruments instruments);

    /** Of something that this world does not have. */
    Gauge NOTHING = (scene, instruments) -> null;

    /**
     * The gauge of what an expression names.
     *
     * @param name of a robot, a drinker or a thing, a dot, and what of it; or what of the world
     * @param type that the expression takes it for
     */
    static Gauge of(World world, String name, Type type) {
        int dot = name.indexOf('.');
        if (dot < 0) {
            return ofWorld(name);
        }
        String owner = name.substring(0, dot);
        String property = name.substring(dot + 1);
        return index(world.robots(), World.Robot::name, owner)
                .map(robot -> ofRobot(world, robot, property, type))
                .or(
                        () ->
                                index(world.drinkers(), World.Drinker::name, owner)
                                        .map(drinker -> ofDrinker(drinker, property)))
                .or(
                        () ->
                                index(world.things(), World.Thing::name, owner)
                                        .map(thing -> ofThing(thing, property)))
                .orElse(NOTHING);
    }

    private static <T> Optional<Integer> index(
            List<T> all, Function<T, String> names, String name) {
        return Optional.of(all.stream().map(names).toList().indexOf(name))
                .filter(index -> index >= 0);
    }

    private static Gauge ofWorld(String property) {
        return switch (property) {
            case TIME -> (scene, instruments) -> new Value.RealValue(scene.time() / MILLISECONDS);
            case DELIVERED -> (scene, instruments) -> new Value.IntegerValue(scene.delivered());
            default -> NOTHING;
        };
    }

    private static Gauge ofRobot(World world, int robot, String property, Type type) {
        if (property.equals(DISPLAY)) {
            return (scene, instruments) -> new Value.StringValue(instruments.display(robot));
        }
        if (property.equals(CUP)) {
            Type.EnumType cup = (Type.EnumType) type;
            return (scene, instruments) ->
                    new Value.EnumValue(cup, scene.robots().get(robot).cup().ordinal());
        }
        if (property.matches(SOCKET + "\\d")) {
            return ofSensor(world, robot, property.charAt(1) - '0');
        }
        return Arrays.stream(RobotProperty.values())
                .filter(each -> each.word().equals(property))
                .findFirst()
                .<Gauge>map(each -> (scene, instruments) -> each.of(scene.robots().get(robot)))
                .orElse(NOTHING);
    }

    private static Gauge ofSensor(World world, int robot, int socket) {
        List<Device.Sensor> sensors = world.robots().get(robot).kind().sensors();
        return IntStream.range(0, sensors.size())
                .filter(i -> sensors.get(i).socket() == socket)
                .<Gauge>mapToObj(
                        i ->
                                (scene, instruments) ->
                                        new Value.IntegerValue(instruments.readings(robot)[i]))
                .findFirst()
                .orElse(NOTHING);
    }

    private static Gauge ofDrinker(int drinker, String property) {
        return switch (property) {
            case PRESENT ->
                    (scene, instruments) ->
                            new Value.BooleanValue(scene.drinkers().get(drinker).present());
            case CUPS ->
                    (scene, instruments) ->
                            new Value.IntegerValue(scene.drinkers().get(drinker).cups());
            default -> NOTHING;
        };
    }

    private static Gauge ofThing(int thing, String property) {
        return switch (property) {
            case X ->
                    (scene, instruments) ->
                            new Value.RealValue(scene.things().get(thing).place().x());
            case Y ->
                    (scene, instruments) ->
                            new Value.RealValue(scene.things().get(thing).place().y());
            default -> NOTHING;
        };
    }
}
