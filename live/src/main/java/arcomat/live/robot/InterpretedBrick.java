package arcomat.live.robot;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.network.Network.Device;
import arcomat.sim.Brick;
import arcomat.sim.BrickRoom;
import arcomat.sim.device.Hardware;
import arcomat.sim.device.LineNotes;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.Observer;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Pattern;

/**
 * A brick with an interpreted program: in each cycle it samples its sensors, lets the model take
 * its slice, and carries out what that says. Where the model goes wrong its motors stop, and the
 * display says why.
 */
public final class InterpretedBrick implements Brick {
    private static final Pattern SLICE = Pattern.compile("^slice \\d+: ");

    private final Hardware brick;
    private final Routine routine;
    private final Interpreter program;
    private final int cycle;
    private final Map<String, PlacedPart> parts = new LinkedHashMap<>();
    private final DeviceOrder order;
    private final Map<String, Value> sampled = new LinkedHashMap<>();
    private Letter shown = Letter.SILENCE;
    private long next;

    private record PlacedPart(Device device, Part part) {
        /** The name of a port by which the program meets it. */
        String named(String port) {
            return device.path() + "." + port;
        }
    }

    private InterpretedBrick(Hardware brick, Component whole) {
        this.brick = brick;
        this.routine = new Routine(brick.time());
        this.program = Interpreter.forgetful(whole, List.of(), Choice.first());
        this.cycle = whole.cycle();
        this.order = DeviceOrder.of(whole);
        PlatformParts library = new PlatformParts(brick, routine);
        for (Device device : program.network().devices()) {
            parts.put(device.path(), new PlacedPart(device, library.of(device)));
        }
    }

    /**
     * A new brick, switched on at this moment.
     *
     * @param whole without parameters; see {@link RobotProgram}
     */
    static InterpretedBrick start(String name, Component whole, BrickRoom room) {
        InterpretedBrick brick = new InterpretedBrick(room.devices(name, new Unthreaded()), whole);
        brick.routine.start(brick::begin);
        return brick;
    }

    private void begin() {
        order.sensed().forEach(path -> routine.then(part(path).part()::begin));
        routine.call(() -> next = brick.milliseconds());
        routine.then(this::slice);
    }

    private PlacedPart part(String path) {
        return Objects.requireNonNull(parts.get(path), path);
    }

    private void slice() {
        routine.call(this::await);
        routine.call(); // for the key that ends a program, which nobody presses here
        routine.loop();
        for (String path : order.sensed()) {
            routine.then(() -> sense(part(path)));
        }
        routine.then(this::react);
    }

    private void await() {
        long wait = next - brick.milliseconds();
        next += cycle;
        if (wait > 0) {
            routine.until(() -> brick.tickAfter(wait), () -> {});
        }
    }

    private void sense(PlacedPart placed) {
        for (Port port : placed.device().component().outputs()) {
            placed.part().sense(message -> sampled.put(placed.named(port.name()), message));
        }
    }

    private void react() {
        try {
            shown = program.step(Letter.of(sampled)).outputs();
        } catch (ModelError problem) {
            new Failure(brick, routine, told(problem)).show();
            return;
        }
        sampled.clear();
        for (String path : order.acted()) {
            PlacedPart placed = part(path);
            routine.then(() -> placed.part().act(port -> shown.message(placed.named(port))));
        }
        routine.then(this::slice);
    }

    /** Without slice and part, which the code on a brick does not know. */
    private String told(ModelError problem) {
        String message = SLICE.matcher(String.valueOf(problem.getMessage())).replaceFirst("");
        return program.network().instances().stream()
                .map(instance -> instance.with(""))
                .filter(message::startsWith)
                .findFirst()
                .map(part -> message.substring(part.length()))
                .orElse(message);
    }

    @Override
    public String name() {
        return brick.name();
    }

    @Override
    public void observe(Observer observer) {
        brick.observe(observer);
    }

    @Override
    public void expose(SensorName socket, Supplier<Stimulus> source) {
        brick.socket(socket.ordinal()).expose(source);
    }

    @Override
    public double speed(MotorName name) {
        return brick.motor(name.ordinal()).speed();
    }

    @Override
    public String row(int number) {
        return brick.screen().row(number);
    }

    @Override
    public boolean isRunning() {
        return true;
    }

    /** As on the brick, where a program catches what its model does wrong. */
    @Override
    public Optional<String> failure() {
        return Optional.empty();
    }

    @Override
    public List<LineNotes> notes() {
        return List.of();
    }
}
