package arcomat.pipeline.campaign.joint;

import arcomat.pipeline.campaign.joint.JointRequirement.WatchedPort;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * One requirement in a run. Each moment is a slice of it, and more than one where a robot has ended
 * several slices since the moment before: no message is lost, and none is seen twice.
 */
final class RequirementRun {
    private final JointQuestion question;
    private final List<ShownSlices> bound;
    private final List<RunningMonitor> monitors;
    private Optional<String> doubt = Optional.empty();

    RequirementRun(JointQuestion question, Map<String, ShownSlices> robots, ClassLoader classes) {
        this.question = question;
        this.bound =
                question.sources().stream()
                        .flatMap(each -> each.robot().stream())
                        .distinct()
                        .map(name -> Objects.requireNonNull(robots.get(name)))
                        .toList();
        this.monitors =
                question.requirement().monitors().stream()
                        .map(type -> RunningMonitor.start(type, question.requirement(), classes))
                        .toList();
    }

    void see(WorldMoment moment) {
        int slices = bound.stream().mapToInt(ShownSlices::count).max().orElse(0);
        for (int slice = 0; slice < Math.max(1, slices) && isOpen(); slice++) {
            try {
                @Nullable Object[] shown = shown(slice, moment);
                monitors.forEach(each -> each.slice(shown));
            } catch (ForeignValue e) {
                doubt = Optional.of("at %s s %s".formatted(moment.seconds(), e.getMessage()));
            }
        }
    }

    private boolean isOpen() {
        return question.isWhole() && doubt.isEmpty() && !isViolated();
    }

    private @Nullable Object[] shown(int slice, WorldMoment moment) throws ForeignValue {
        List<WatchedPort> ports = question.requirement().ports();
        @Nullable Object[] shown = new @Nullable Object[ports.size()];
        for (int i = 0; i < shown.length; i++) {
            shown[i] = message(i, slice, moment);
            if (shown[i] == null && ports.get(i).total()) {
                throw new ForeignValue(
                        "'%s' has no value, and wants one at every moment"
                                .formatted(ports.get(i).name()));
            }
        }
        return shown;
    }

    private @Nullable Object message(int port, int slice, WorldMoment moment) throws ForeignValue {
        try {
            return question.sources().get(port).reader().read(slice, moment);
        } catch (ForeignValue e) {
            String name = question.requirement().ports().get(port).name();
            throw new ForeignValue("'%s' has no value: %s".formatted(name, e.getMessage()));
        }
    }

    void end() {
        if (isOpen()) {
            monitors.forEach(RunningMonitor::end);
        }
    }

    private boolean isViolated() {
        return monitors.stream().anyMatch(RunningMonitor::isViolated);
    }

    /** Empty where something was violated: what is not known changes nothing then. */
    Optional<String> doubt() {
        if (isViolated()) {
            return Optional.empty();
        }
        return doubt.or(
                        () ->
                                monitors.stream()
                                        .map(RunningMonitor::unknown)
                                        .filter(each -> !each.isEmpty())
                                        .findFirst())
                .map(why -> question.requirement().column() + ": " + why);
    }

    double answer() {
        if (!question.isWhole()) {
            return Double.NaN;
        }
        return isViolated() ? 1 : 0;
    }
}
