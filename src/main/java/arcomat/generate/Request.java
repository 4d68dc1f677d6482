package arcomat.generate;

import arcomat.generate.monitor.SelfWatch;
import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.model.Model;

import java.util.List;
import java.util.Map;

/**
 * What is to be generated.
 *
 * @param components with all their parts
 * @param handwritten texts of implementations of platform components, by their path
 * @param programs those of them that get a main program: they take no arguments
 * @param watches what programs watch themselves for
 * @param traced whether components note which transition they took, for those who look at a run
 */
public record Request(
        List<Component> components,
        List<Component> programs,
        Choosing choosing,
        Map<String, String> handwritten,
        List<SelfWatch> watches,
        boolean traced) {
    public Request {
        components = List.copyOf(components);
        programs = List.copyOf(programs);
        handwritten = Map.copyOf(handwritten);
        watches = List.copyOf(watches);
    }

    /** The same with implementations of platform components, for targets that need them. */
    public Request with(Map<String, String> implementations) {
        return new Request(components, programs, choosing, implementations, watches, traced);
    }

    /** The same with programs that watch themselves, for targets whose programs do. */
    public Request watching(List<SelfWatch> wanted) {
        return new Request(components, programs, choosing, handwritten, wanted, traced);
    }

    /** The same with components that can be looked at. */
    public Request withTrace() {
        return new Request(components, programs, choosing, handwritten, watches, true);
    }

    /** Every component of a model, and a program for each that is to be deployed. */
    public static Request all(Model model, Choosing choosing) {
        return all(model.components(), choosing);
    }

    /** Components with all their parts, and a program for each that is to be deployed. */
    public static Request all(List<Component> components, Choosing choosing) {
        return all(Deployment.of(components), choosing);
    }

    /** The same, where somebody wants to know what is not deployed, too. */
    public static Request all(Deployment deployed, Choosing choosing) {
        return new Request(
                deployed.components(), deployed.programs(), choosing, Map.of(), List.of(), false);
    }

    /** One component with its parts and a program for it. */
    public static Request program(Component main, Choosing choosing) {
        return new Request(List.of(main), List.of(main), choosing, Map.of(), List.of(), false);
    }

    /** One component with its parts, to be driven from outside. */
    public static Request library(Component component, Choosing choosing) {
        return new Request(List.of(component), List.of(), choosing, Map.of(), List.of(), false);
    }
}
