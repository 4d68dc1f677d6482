package arcomat.pipeline.world;

import arcomat.model.Refusal;
import arcomat.pipeline.inside.Refusing;
import arcomat.sim.device.Observer;
import arcomat.sim.device.SilentObserver;
import arcomat.sim.device.Stimulus;
import arcomat.sim.time.VirtualTime;
import arcomat.sim.trace.Lateness;
import arcomat.world.Kind;
import arcomat.world.Point;
import arcomat.world.Recording;
import arcomat.world.Recording.Event;
import arcomat.world.Recording.Frame;
import arcomat.world.Recording.RobotFrame;
import arcomat.world.Scene;
import arcomat.world.Scene.Happening;
import arcomat.world.Scene.RobotState;
import arcomat.world.Scene.ThingState;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.World.Robot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/** Writes down what happens in a world. */
public final class WorldRecorder implements Witness {
    private final World world;
    private final Seeds seeds;
    private final List<Frame> frames = new ArrayList<>();
    private final List<Event> events = new ArrayList<>();
    private final Map<String, String> failures = new TreeMap<>();
    private final Set<Recording.Blind> blind = new LinkedHashSet<>();
    private final Map<String, Lateness> lateness = new TreeMap<>();
    private final String[] displays;
    private final Map<String, Refusing> refusing;
    private final Map<String, Map<String, List<Recording.Reason>>> reasons = new TreeMap<>();

    public WorldRecorder(World world, Seeds seeds) {
        this(world, seeds, Map.of());
    }

    /**
     * @param refusing who knows why robots do nothing, by their names
     */
    WorldRecorder(World world, Seeds seeds, Map<String, Refusing> refusing) {
        this.world = world;
        this.seeds = seeds;
        this.refusing = refusing;
        displays = new String[world.robots().size()];
        Arrays.fill(displays, "");
    }

    /** Hears what a robot sends, and sees where it takes its sensors for what they are not. */
    @Override
    public Observer of(Robot robot) {
        return new SilentObserver() {
            @Override
            public void sensorRead(long time, int socket, int value) {
                Kind kind = robot.kind();
                if (kind.sensors().stream().noneMatch(s -> s.socket() == socket + 1)
                        && kind.described().stream().noneMatch(d -> d.socket() == socket + 1)) {
                    blind.add(new Recording.Blind(robot.name(), socket + 1, Optional.empty()));
                }
            }

            @Override
            public void misfit(long time, int socket, String sensor, Stimulus stimulus) {
                blind.add(new Recording.Blind(robot.name(), socket + 1, Optional.of(sensor)));
            }

            @Override
            public void late(long from, long until) {
                lateness.merge(
                        robot.name(),
                        Lateness.NONE.and(until - from),
                        (all, one) -> all.and(one.longest()));
            }

            @Override
            public void entered(long time, Object object, String method) {
                Refusing own = refusing.get(robot.name());
                if (own != null) {
                    int now = (int) (time / VirtualTime.MILLISECOND);
                    own.entered(now, object, method)
                            .ifPresent(said -> note(now, robot.name(), said));
                }
            }

            @Override
            public void packetSent(long time, byte[] packet, int length) {
                events.add(
                        new Event.Sent(
                                (int) (time / VirtualTime.MILLISECOND),
                                robot.name(),
                                hexadecimal(packet, length)));
            }
        };
    }

    /** Said here, since a browser does not have what Java has for it. */
    private static String hexadecimal(byte[] packet, int length) {
        StringBuilder digits = new StringBuilder();
        for (int i = 0; i < length; i++) {
            digits.append(Character.forDigit(packet[i] >> 4 & 0xf, 16));
            digits.append(Character.forDigit(packet[i] & 0xf, 16));
        }
        return digits.toString();
    }

    /** Only what is another reason than before. */
    private void note(int time, String robot, Refusing.Said said) {
        List<Recording.Reason> own =
                reasons.computeIfAbsent(robot, any -> new TreeMap<>())
                        .computeIfAbsent(said.part(), any -> new ArrayList<>());
        String words = said.nearest().map(Refusal::words).orElse("");
        String last = own.isEmpty() ? "" : own.get(own.size() - 1).words();
        if (!words.equals(last)) {
            own.add(new Recording.Reason(time, words));
        }
    }

    private List<Recording.Idle> idle() {
        List<Recording.Idle> idle = new ArrayList<>();
        reasons.forEach(
                (robot, parts) ->
                        parts.forEach(
                                (part, own) -> idle.add(new Recording.Idle(robot, part, own))));
        return idle;
    }

    @Override
    public void failed(String robot, String reason) {
        failures.put(robot, reason);
    }

    /** What it has written down. */
    public Recording recording() {
        return new Recording(
                world, seeds, frames, events, failures, List.copyOf(blind), late(), idle());
    }

    private List<Recording.Late> late() {
        return lateness.entrySet().stream()
                .map(
                        each ->
                                new Recording.Late(
                                        each.getKey(),
                                        each.getValue().slices(),
                                        each.getValue().longest()))
                .toList();
    }

    @Override
    public void see(Scene scene, Instruments instruments) {
        int time = scene.time();
        for (Happening happening : scene.happenings()) {
            events.add(new Event.Happened(time, happening));
        }
        if (time % Recording.PERIOD != 0) {
            return;
        }
        List<RobotFrame> robots = new ArrayList<>();
        for (int i = 0; i < displays.length; i++) {
            look(i, time, instruments.display(i));
            robots.add(frame(scene.robots().get(i), instruments.readings(i), displays[i]));
        }
        List<Point> things = scene.things().stream().map(ThingState::place).toList();
        frames.add(new Frame(time, robots, scene.drinkers(), things));
    }

    private void look(int index, int time, String shown) {
        if (!shown.equals(displays[index])) {
            displays[index] = shown;
            events.add(new Event.Showed(time, world.robots().get(index).name(), shown));
        }
    }

    private static RobotFrame frame(RobotState state, int[] readings, String display) {
        return new RobotFrame(
                state.pose(),
                state.left(),
                state.right(),
                Arrays.stream(readings).boxed().toList(),
                state.cup(),
                display,
                state.stock(),
                state.brewing() > 0);
    }
}
