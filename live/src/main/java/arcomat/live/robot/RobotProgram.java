package arcomat.live.robot;

import arcomat.model.Component;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.semantics.network.Network;
import arcomat.semantics.network.Network.Device;
import arcomat.sim.Brick;
import arcomat.sim.BrickRoom;
import arcomat.world.Kind;

import java.util.List;
import java.util.stream.Collectors;

/**
 * A program that can be interpreted.
 *
 * @param whole time-synchronous, without parameters and with known platform components only
 */
record RobotProgram(Component whole) {
    /**
     * @throws WrongUse where it cannot, and why
     */
    static RobotProgram of(Kind.Program program, LoweredModels models) throws WrongUse {
        if (program.form() == Kind.Program.Form.JAR) {
            throw new WrongUse(
                    "'%s' is a jar, and here only models run; use arcomat world", program.name());
        }
        Component whole = MainComponent.find(program.name(), models).closed();
        if (!whole.isComposite()) {
            throw new WrongUse(
                    "'%s' has no parts, and so nothing of a robot", whole.qualifiedName());
        }
        if (whole.profile() != Component.Profile.TIME_SYNCHRONOUS) {
            throw new WrongUse(
                    "'%s' reacts to events, and here only programs with slices run; use arcomat"
                            + " world",
                    whole.qualifiedName());
        }
        requireKnown(whole);
        return new RobotProgram(whole);
    }

    private static void requireKnown(Component whole) throws WrongUse {
        List<Device> strange =
                Network.of(whole, List.of()).devices().stream()
                        .filter(device -> !PlatformParts.isKnown(device.component()))
                        .toList();
        if (!strange.isEmpty()) {
            throw new WrongUse(
                    "'%s' needs %s, and only Java says what that does; use arcomat world",
                    whole.qualifiedName(),
                    strange.stream()
                            .map(device -> device.component().qualifiedName())
                            .distinct()
                            .collect(Collectors.joining(", ")));
        }
    }

    /** A new brick that has it, switched on at this moment. */
    Brick start(String name, BrickRoom room) {
        return InterpretedBrick.start(name, whole, room);
    }
}
