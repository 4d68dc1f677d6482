package arcomat.pipeline.campaign.watch;

import arcomat.campaign.JointWatch.Binding;
import arcomat.campaign.JointWatch.RobotPort;
import arcomat.generate.CodeLayout;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.joint.PortTap;
import arcomat.pipeline.campaign.joint.ProgramTaps;
import arcomat.pipeline.campaign.measure.MeasuredExpression;
import arcomat.pipeline.campaign.measure.Vocabulary;
import arcomat.pipeline.generate.ProgramParts;
import arcomat.source.Diagnostic;
import arcomat.source.Nearest;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;

/** What ports of requirements are bound to, and where programs show it. */
final class JointBindings {
    private final CampaignCode code;
    private final List<WatchedRoot> roots;
    private final Vocabulary vocabulary;

    /** By what worlds say of programs, and by path. */
    private final Map<String, Map<String, PortTap>> taps = new TreeMap<>();

    JointBindings(CampaignCode code, List<WatchedRoot> roots, Vocabulary vocabulary) {
        this.code = code;
        this.roots = roots;
        this.vocabulary = vocabulary;
    }

    /** What is looked at in which program. */
    Map<String, ProgramTaps> programs() {
        Map<String, ProgramTaps> programs = new TreeMap<>();
        taps.forEach(
                (key, own) ->
                        programs.put(
                                key,
                                new ProgramTaps(
                                        place(key, component(key)).className(),
                                        List.copyOf(own.values()))));
        return programs;
    }

    /** Binds a port of a requirement, or says why it cannot. */
    List<Diagnostic> bind(Port port, Binding binding) {
        try {
            if (binding.robotPort().isPresent()) {
                bind(port, binding.robotPort().get());
                return List.of();
            }
            requireReadable(port);
            return MeasuredExpression.read(binding.source(), port.type().name(), vocabulary)
                    .findings();
        } catch (WrongUse e) {
            return List.of(
                    Diagnostic.error(
                            WatchFreight.NOT_WATCHED,
                            binding.source(),
                            String.valueOf(e.getMessage())));
        }
    }

    /** Worlds know no types of models. */
    private static void requireReadable(Port port) throws WrongUse {
        Type type = port.type();
        boolean isReadable =
                type.isNumber()
                        || type instanceof Type.BooleanType
                        || type instanceof Type.StringType;
        if (!isReadable) {
            throw new WrongUse(
                    "'%s' is of type %s, and nothing that can be read in a world is: name a port of"
                            + " a robot's program, ROBOT.PART.PORT",
                    port.name(), type.name());
        }
    }

    private void bind(Port port, RobotPort shown) throws WrongUse {
        Set<String> programs = code.robots().get(shown.robot());
        if (programs == null) {
            throw unknown("there is no robot '%s'", shown.robot(), code.robots().keySet());
        }
        if (port.total()) {
            throw new WrongUse(
                    "'%s' always has a message, and a port of a robot has one in its own slices"
                            + " only: leave out <<total>> in the requirement",
                    port.name());
        }
        for (String program : programs) {
            PortTap tap = tap(port, shown, program);
            taps.computeIfAbsent(program, key -> new LinkedHashMap<>()).put(shown.path(), tap);
        }
    }

    private PortTap tap(Port port, RobotPort shown, String program) throws WrongUse {
        if (!code.layouts().containsKey(program)) {
            throw new WrongUse(
                    "the program of '%s' was given as a jar, so nobody knows its ports",
                    shown.robot());
        }
        Component whole = component(program);
        Map<String, Component> parts = ProgramParts.of(whole);
        Component part = parts.get(shown.part());
        if (part == null) {
            String message = "'%s', the program of '%s', has no part '%%s'";
            throw unknown(
                    message.formatted(whole.qualifiedName(), shown.robot()),
                    shown.part(),
                    parts.keySet());
        }
        Port there = port(shown, part);
        requireSame(port, shown, there);
        String fields = ProgramParts.fields(whole, shown.part(), layout(program));
        CodeLayout.Place place = place(program, part);
        String flag = place.presences().getOrDefault(shown.port(), "");
        return new PortTap(
                shown.path(),
                fields,
                Objects.requireNonNull(place.messages().get(shown.port())),
                flag,
                there.type() instanceof Type.EnumType,
                !there.isInput() && there.delay() > 0);
    }

    private static Port port(RobotPort shown, Component part) throws WrongUse {
        if (part.profile() != Component.Profile.TIME_SYNCHRONOUS) {
            throw new WrongUse(
                    "part '%s' handles events, and what is watched are slices", shown.part());
        }
        List<String> names = part.ports().stream().map(Port::name).toList();
        String message = "part '%s' is of '%s', which has no port '%%s'";
        return part.port(shown.port())
                .orElseThrow(
                        () ->
                                unknown(
                                        message.formatted(shown.part(), part.qualifiedName()),
                                        shown.port(),
                                        names));
    }

    private static void requireSame(Port port, RobotPort shown, Port there) throws WrongUse {
        if (!port.type().equals(there.type())) {
            throw new WrongUse(
                    "'%s' is of type %s, and '%s.%s' of type %s",
                    port.name(),
                    port.type().name(),
                    shown.robot(),
                    shown.path(),
                    there.type().name());
        }
        if (port.type() instanceof Type.ClassType) {
            throw new WrongUse(
                    "'%s' is of type %s: several robots cannot be watched for objects",
                    port.name(), port.type().name());
        }
    }

    private static WrongUse unknown(String message, String name, Collection<String> known) {
        List<String> there = known.stream().filter(each -> !each.isEmpty()).sorted().toList();
        String hint =
                Nearest.to(name, there)
                        .map(meant -> "; did you mean '" + meant + "'?")
                        .orElseGet(() -> "; there are " + String.join(", ", there));
        return new WrongUse("%s", message.formatted(name) + hint);
    }

    private Component component(String program) {
        return roots.stream()
                .map(root -> root.components().get(program))
                .filter(Objects::nonNull)
                .findFirst()
                .orElseThrow();
    }

    private CodeLayout layout(String program) {
        return Objects.requireNonNull(code.layouts().get(program));
    }

    private CodeLayout.Place place(String program, Component component) {
        return Objects.requireNonNull(layout(program).components().get(component.qualifiedName()));
    }
}
