package arcomat.pipeline.campaign.joint;

import arcomat.pipeline.campaign.joint.JointRequirement.WatchedPort;
import arcomat.pipeline.compile.Slot;
import arcomat.rt.Monitor;

import org.jspecify.annotations.Nullable;

import java.lang.reflect.Constructor;
import java.util.ArrayList;
import java.util.List;

/** A generated monitor in a run. */
final class RunningMonitor {
    /** With more runs to follow it gives up: nobody waits for a campaign that long. */
    private static final int MOST_RUNS = 1000;

    private static final Integer NOTHING = 0;

    private final Monitor monitor;
    private final List<Port> ports = new ArrayList<>();

    /** What takes the message of a port. */
    private record Port(Slot message, @Nullable Slot flag, boolean silentAtZero) {
        void show(@Nullable Object shown) {
            if (flag != null) {
                flag.set(shown != null);
            }
            if (shown != null) {
                message.set(shown);
            } else if (silentAtZero) {
                message.set(NOTHING);
            }
        }
    }

    private RunningMonitor(Monitor monitor, List<WatchedPort> watched) {
        this.monitor = monitor;
        for (WatchedPort each : watched) {
            Slot message = new Slot(monitor, each.field());
            Slot flag = each.flag().isEmpty() ? null : new Slot(monitor, each.flag());
            ports.add(new Port(message, flag, flag == null && !each.total()));
        }
    }

    static RunningMonitor start(String type, JointRequirement requirement, ClassLoader classes) {
        try {
            Constructor<?> constructor = classes.loadClass(type).getConstructors()[0];
            List<Object> arguments = new ArrayList<>();
            for (Class<?> each : constructor.getParameterTypes()) {
                arguments.add(FieldValue.read(requirement.arguments().get(arguments.size()), each));
            }
            Monitor monitor = (Monitor) constructor.newInstance(arguments.toArray());
            monitor.followAtMost(MOST_RUNS);
            return new RunningMonitor(monitor, requirement.ports());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Judges a slice.
     *
     * @param shown one for each port; null where there is no message
     */
    void slice(@Nullable Object[] shown) {
        for (int i = 0; i < shown.length; i++) {
            ports.get(i).show(shown[i]);
        }
        monitor.slice();
    }

    /** The run is over. */
    void end() {
        monitor.end();
    }

    boolean isViolated() {
        return !monitor.violation().isEmpty();
    }

    /** Why it does not know; empty if it does. */
    String unknown() {
        return monitor.unknown();
    }
}
