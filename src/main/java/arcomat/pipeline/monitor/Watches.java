package arcomat.pipeline.monitor;

import arcomat.analysis.Promise;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Port;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.pipeline.step.WrongUse;
import arcomat.simulate.Watch;

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
    public static List<Watch> of(
            List<String> monitors, Component running, CheckedModels checked, Model model)
            throws WrongUse {
        List<Watch> watches = new ArrayList<>();
        for (String written : monitors) {
            Promise promise = promise(written, checked, model);
            requirePorts(promise.component(), running);
            for (Automaton automaton : promise.automata()) {
                watches.add(new Watch(promise.component(), automaton, promise.arguments()));
            }
        }
        return watches;
    }

    /** What can be watched for: automata over slices. */
    static Promise promise(String written, CheckedModels checked, Model model) throws WrongUse {
        Promise all = PromiseReference.parse(written).in(checked, model);
        Component component = all.component();
        Promise promise =
                all.automata().isEmpty() ? Promise.required(component, all.arguments()) : all;
        String name = "component '" + component.qualifiedName() + "'";
        if (promise.automata().isEmpty() || component.platform()) {
            throw new WrongUse(name + " has no automaton, so there is nothing to watch for");
        }
        if (component.profile() == Component.Profile.EVENT_DRIVEN) {
            throw new WrongUse(name + " is driven by events, and monitors judge slices");
        }
        return promise;
    }

    private static void requirePorts(Component required, Component running) throws WrongUse {
        for (Port port : required.ports()) {
            Optional<Port> found =
                    running.port(port.name())
                            .filter(p -> p.isInput() == port.isInput())
                            .filter(p -> p.type().equals(port.type()));
            String wanted =
                    "'"
                            + required.qualifiedName()
                            + "' cannot watch '"
                            + running.qualifiedName()
                            + "': ";
            if (found.isEmpty()) {
                String direction = port.isInput() ? "input" : "output";
                throw new WrongUse(
                        wanted
                                + "that has no "
                                + direction
                                + " '"
                                + port.name()
                                + "' of type "
                                + port.type().name());
            }
            if (!running.isComposite()
                    && !required.isComposite()
                    && found.get().delay() != port.delay()) {
                throw new WrongUse(
                        wanted
                                + "output '"
                                + port.name()
                                + "' has delay "
                                + found.get().delay()
                                + " there and is to have delay "
                                + port.delay());
            }
        }
    }
}
