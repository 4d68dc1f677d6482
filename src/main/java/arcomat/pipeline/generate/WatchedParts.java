package arcomat.pipeline.generate;

import arcomat.generate.monitor.SelfWatch;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.semantics.Promise;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Finds what a program is to watch itself for. {@code drive=p.Brakes} names the part; without one,
 * all those are meant that say that they keep the requirement, and else the whole.
 */
public final class WatchedParts {
    private static final Pattern WRITTEN = Pattern.compile("(?:([\\w.]+)=)?(.*)");

    private final LoweredModels models;

    private WatchedParts(LoweredModels models) {
        this.models = models;
    }

    /**
     * @param monitors as written
     * @param programs the components that programs run
     * @throws WrongUse where there is no such requirement, or nothing to watch for it
     */
    public static List<SelfWatch> of(
            List<String> monitors, List<Component> programs, LoweredModels models) throws WrongUse {
        List<SelfWatch> all = new ArrayList<>();
        for (String written : monitors) {
            List<SelfWatch> found = new WatchedParts(models).find(written, programs);
            found.stream().filter(watch -> !all.contains(watch)).forEach(all::add);
        }
        return all;
    }

    /** What is to be watched for, without the parts. */
    public static List<String> requirements(List<String> monitors) {
        return monitors.stream().map(written -> apart(written).group(2)).toList();
    }

    private static MatchResult apart(String written) {
        Matcher matcher = WRITTEN.matcher(written);
        matcher.matches();
        return matcher.toMatchResult();
    }

    private List<SelfWatch> find(String written, List<Component> programs) throws WrongUse {
        MatchResult apart = apart(written);
        Promise promise = Watches.promise(apart.group(2), models);
        requireSlices(promise.component());
        List<SelfWatch> found = new ArrayList<>();
        for (Component program : programs) {
            Map<String, Component> places =
                    places(program, Optional.ofNullable(apart.group(1)), promise.component());
            for (Map.Entry<String, Component> place : places.entrySet()) {
                requirePorts(promise.component(), place.getValue());
                for (Automaton automaton : promise.automata()) {
                    found.add(
                            new SelfWatch(
                                    program,
                                    place.getKey(),
                                    place.getValue(),
                                    promise.component(),
                                    automaton,
                                    promise.arguments()));
                }
            }
        }
        if (found.isEmpty()) {
            throw new WrongUse(nothing(promise.component(), apart.group(1), programs));
        }
        return found;
    }

    private static void requireSlices(Component required) throws WrongUse {
        if (required.profile() != Component.Profile.TIME_SYNCHRONOUS) {
            throw new WrongUse(
                    "'%s' handles events; a program for the brick can watch itself only for what"
                            + " works slice by slice",
                    required.qualifiedName());
        }
    }

    /** Parts of a program by their path; the whole has none. */
    private Map<String, Component> places(
            Component program, Optional<String> part, Component required) {
        Map<String, Component> places = new LinkedHashMap<>(ProgramParts.of(program));
        if (part.isPresent()) {
            places.keySet().removeIf(path -> !path.equals(part.get()));
            return places;
        }
        places.values().removeIf(component -> !keeps(component, required));
        return places.isEmpty() && !required.ports().isEmpty() && hasPorts(program, required)
                ? Map.of("", program)
                : places;
    }

    /** Whether it is the same, or says that it refines it, be it in several steps. */
    private boolean keeps(Component component, Component required) {
        return component.qualifiedName().equals(required.qualifiedName())
                || component.refines().stream()
                        .flatMap(name -> models.model().component(name).stream())
                        .anyMatch(refined -> keeps(refined, required));
    }

    private static boolean hasPorts(Component running, Component required) {
        return required.ports().stream().allMatch(port -> running.port(port.name()).isPresent());
    }

    /** A port that always has a message cannot say that it has none. */
    private static void requirePorts(Component required, Component running) throws WrongUse {
        Watches.requirePorts(required, running);
        for (Port port : required.ports()) {
            if (port.total() && !running.port(port.name()).orElseThrow().total()) {
                throw new WrongUse(
                        "'%s' cannot watch '%s': '%s' has a message in every slice there, and not"
                                + " here",
                        required.qualifiedName(), running.qualifiedName(), port.name());
            }
        }
    }

    private static String nothing(
            Component required, @Nullable String part, List<Component> programs) {
        String name = required.qualifiedName();
        List<String> names = programs.stream().map(Component::qualifiedName).toList();
        String where = names.isEmpty() ? "no program" : String.join(", ", names);
        return part == null
                ? "nothing in "
                        + where
                        + " says that it keeps '"
                        + name
                        + "'; name the part that is to be watched: --monitor PART="
                        + name
                : where + " has no part '" + part + "' to be watched for '" + name + "'";
    }
}
