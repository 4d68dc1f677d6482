package arcomat.pipeline.campaign.measure;

import arcomat.model.Value;
import arcomat.world.Scene.RobotState;

import java.util.Locale;
import java.util.function.Function;

/** What can be read of every robot, beside its sensors, its display and its cup. */
enum RobotProperty {
    /** In mm. */
    X("Double", robot -> new Value.RealValue(robot.pose().point().x())),
    /** In mm. */
    Y("Double", robot -> new Value.RealValue(robot.pose().point().y())),
    /** In degrees, from -180 to 180; 0 along x and growing to the left. */
    HEADING("Double", robot -> new Value.RealValue(degrees(robot.pose().heading()))),
    /** Speed over the floor at the left wheel, in mm per second. */
    LEFT("Double", robot -> new Value.RealValue(robot.left())),
    /** Likewise. */
    RIGHT("Double", robot -> new Value.RealValue(robot.right())),
    /** Whether it pushes against something that does not move. */
    TOUCHING("Boolean", robot -> new Value.BooleanValue(robot.touching())),
    /** Whether it pushes a thing. */
    PUSHING("Boolean", robot -> new Value.BooleanValue(robot.pushing())),
    /** Cups in its magazine. */
    STOCK("Integer", robot -> new Value.IntegerValue(robot.stock())),
    /** Whether its coffee machine works. */
    BREWING("Boolean", robot -> new Value.BooleanValue(robot.brewing() > 0));

    private final String type;

    @SuppressWarnings("ImmutableEnumChecker") // a function of its argument alone
    private final Function<RobotState, Value> value;

    RobotProperty(String type, Function<RobotState, Value> value) {
        this.type = type;
        this.value = value;
    }

    String word() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** As models write it. */
    String type() {
        return type;
    }

    Value of(RobotState robot) {
        return value.apply(robot);
    }

    private static double degrees(double radians) {
        return Math.IEEEremainder(Math.toDegrees(radians), 360);
    }
}
