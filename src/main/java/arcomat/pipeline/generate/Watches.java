package arcomat.pipeline.generate;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.semantics.Promise;
import arcomat.simulate.watch.Watch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Finds the requirements that a run is to be watched for. */
public final class Watches {
    private Watches() {}

    /**
     * @param monitors as written
     * @param running the component whose ports are watched
     */
    public static List<Watch> of(List<String> monitors, Component running, LoweredModels models)
            throws WrongUse {
        List<Watch> watches = new ArrayList<>();
        for (String written : monitors) {
            Promise promise = promise(written, models);
            Component required = promise.component();
            requirePorts(required, running);
            for (Automaton automaton : promise.automata()) {
                watches.add(new Watch(required, automaton, promise.arguments(), running));
            }
        }
        return watches;
    }

    /** What can be watched for: automata. */
    public static Promise promise(String written, LoweredModels models) throws WrongUse {
        Promise promise = PromiseReference.parse(written).automataIn(models);
        Component component = promise.component();
        String name = "component '" + component.qualifiedName() + "'";
        if (promise.automata().isEmpty() || component.platform()) {
            throw new WrongUse(name + " has no automaton, so there is nothing to watch for");
        }
        return promise;
    }

    /**
     * The requirement is about ports that are there; when they show something is its own affair.
     */
    static void requirePorts(Component required, Component running) throws WrongUse {
        String wanted =
                "'%s' cannot watch '%s': "
                        .formatted(required.qualifiedName(), running.qualifiedName());
        if (required.profile() != running.profile()) {
            throw new WrongUse(
                    wanted + "one of them handles events, the other one works slice by slice");
        }
        for (Port port : required.ports()) {
            Optional<Port> found =
                    running.port(port.name())
                            .filter(p -> p.isInput() == port.isInput())
                            .filter(p -> p.type().equals(port.type()));
            if (found.isEmpty()) {
                String direction = port.isInput() ? "input" : "output";
                throw new WrongUse(
                        "%sthat has no %s '%s' of type %s",
                        wanted, direction, port.name(), port.type().name());
            }
            if (found.get().latched() != port.latched()) {
                throw new WrongUse(
                        "%s'%s' keeps its value in one of them, and is an event in the other",
                        wanted, port.name());
            }
        }
    }
}
