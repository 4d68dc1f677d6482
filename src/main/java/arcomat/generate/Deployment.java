package arcomat.generate;

import arcomat.model.Component;
import arcomat.semantics.expression.Arguments;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Specialization;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What models have to be deployed, as a program starts it: with nobody to give it arguments. Where
 * all parameters have defaults, these stand in its text.
 *
 * @param components all that there are; those that are programs, as programs have them
 * @param programs those that are to be deployed and can be
 * @param findings {@code ARC0811}: why others cannot
 */
public record Deployment(
        List<Component> components, List<Component> programs, List<Diagnostic> findings) {
    private static final String TAKES_ARGUMENTS = "ARC0811";

    public Deployment {
        components = List.copyOf(components);
        programs = List.copyOf(programs);
        findings = List.copyOf(findings);
    }

    public static Deployment of(List<Component> all) {
        List<Component> components = new ArrayList<>();
        List<Component> programs = new ArrayList<>();
        List<Diagnostic> findings = new ArrayList<>();
        for (Component each : all) {
            Optional<String> obstacle = each.deploy() ? obstacle(each, all) : Optional.empty();
            obstacle.ifPresent(reason -> findings.add(finding(each, reason)));
            boolean isProgram = each.deploy() && obstacle.isEmpty();
            Component component = isProgram ? withDefaults(each) : each;
            components.add(component);
            if (isProgram) {
                programs.add(component);
            }
        }
        return new Deployment(components, programs, findings);
    }

    private static Component withDefaults(Component component) {
        return component.parameters().isEmpty()
                ? component
                : Specialization.of(component, Arguments.complete(component, List.of()));
    }

    private static Optional<String> obstacle(Component component, List<Component> all) {
        if (component.parameters().isEmpty()) {
            return Optional.empty();
        }
        if (!component.hasDefaults()) {
            return Optional.of(
                    "it takes arguments, and nobody gives some to a program; give each parameter a"
                            + " default, or name the component with its arguments as the one that"
                            + " runs (--main)");
        }
        if (!component.isComposite()) {
            return Optional.of(
                    "it takes arguments and has no parts to pass them on to; deploy a component"
                            + " that it is a part of");
        }
        if (all.stream().anyMatch(whole -> hasPart(whole, component))) {
            return Optional.of(
                    "it is a part as well, with arguments of its own; name what runs (--main)");
        }
        return computationFault(component);
    }

    private static boolean hasPart(Component whole, Component part) {
        return whole.body() instanceof Component.Composite body
                && body.parts().stream()
                        .anyMatch(
                                each ->
                                        each.component()
                                                .qualifiedName()
                                                .equals(part.qualifiedName()));
    }

    private static Optional<String> computationFault(Component component) {
        try {
            Arguments.complete(component, List.of());
            return Optional.empty();
        } catch (Fault fault) {
            return Optional.of("its defaults go wrong: " + fault.getMessage());
        }
    }

    private static Diagnostic finding(Component component, String reason) {
        String message =
                "there is no program of '"
                        + component.qualifiedName()
                        + "', which is to be deployed: "
                        + reason;
        return Diagnostic.error(TAKES_ARGUMENTS, component.span(), message);
    }
}
